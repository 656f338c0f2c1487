"""How long the certificates that are made here hold, when they are renewed, and when people are told of an end."""

import datetime as dt
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from cryptography import x509

ROOT_LIFE: Final = dt.timedelta(days=3653)
INTERMEDIATE_LIFE: Final = dt.timedelta(days=1096)
LEAF_LIFE: Final = dt.timedelta(days=397)  # of the machine's own; browsers refuse more than 398 days
BACKDATED: Final = dt.timedelta(days=1)  # a tablet's clock may be a little late
LEFT: Final = 1 / 3  # of its time, below which a certificate is renewed
ROOT_ENDS_SOON: Final = 2 * LEAF_LIFE  # before its end people are told
OWN_ENDS_SOON: Final = dt.timedelta(days=14)  # likewise, of a certificate from another authority


def needs_renewal(certificate: "x509.Certificate", now: dt.datetime) -> bool:
    """Return whether too little of a certificate's time is left, or its time has not begun."""
    start, end = certificate.not_valid_before_utc, certificate.not_valid_after_utc
    return now < start or end - now < (end - start) * LEFT
