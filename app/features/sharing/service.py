"""Share links: one session or the course of a patient, read only, for at most `MOST_DAYS`, with a PIN told otherwise.

Token and PIN are never stored, only their hashes. A try at the PIN is counted before it is hashed, and a right one is
taken back. After `MOST_WRONG_PINS` wrong tries a link is dead.
"""

import hashlib
import secrets
from dataclasses import dataclass
from datetime import datetime, timedelta
from typing import Literal

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.features.sharing.tables import ShareLink, ShareVisit
from app.refusals import Conflict
from app.store.access.visible_patients import own_clinic_id
from app.store.consent import has_consented, require_consent
from app.store.own_rows import own_row
from app.store.patients import find_patient
from app.store.tables import Patient
from app.texts import Text

TOKEN_BYTES = 32
PIN_DIGITS = 6
MOST_DAYS = 14  # that a link can be opened; pages read it as the limit of `NewShare`
MOST_WRONG_PINS = 5
MOST_LINKS = 20  # of one patient that can be opened at the same time
VISIT = timedelta(hours=1)

ShareState = Literal["open", "revoked", "over", "dead"]


@dataclass(frozen=True, slots=True)
class SharedRecords:
    """What a visitor of a share link reads."""

    share_id: int
    patient_id: int
    session_id: int | None  # None: all sessions
    expires: datetime


def new_pin() -> str:
    """Return a random PIN."""
    return f"{secrets.randbelow(10**PIN_DIGITS):0{PIN_DIGITS}}"


def _hash(token: str) -> str:
    return hashlib.sha256(token.encode()).hexdigest()


def add_share(
    db: Session, patient_id: int, session_id: int | None, pin_hash: str, days: int, person: str
) -> tuple[ShareLink, str]:
    """Make a link for a patient who consents to sharing; return it with its token, which is stored nowhere."""
    find_patient(db, patient_id)
    require_consent(db, patient_id, "sharing")
    if sum(share_state(link) == "open" for link in shares_of(db, patient_id)) >= MOST_LINKS:
        raise Conflict(Text("sharing-links-most", most=MOST_LINKS))
    token, now = secrets.token_urlsafe(TOKEN_BYTES), utc_now()
    link = ShareLink(
        clinic_id=own_clinic_id(db),
        patient_id=patient_id,
        session_id=session_id,
        token_hash=_hash(token),
        pin_hash=pin_hash,
        person=person,
        created=now,
        expires=now + timedelta(days=min(days, MOST_DAYS)),
        revoked=None,
        wrong_pins=0,
        openings=0,
    )
    db.add(link)
    db.flush()
    return link, token


def shares_of(db: Session, patient_id: int) -> list[ShareLink]:
    """Return the links of a patient, the newest first."""
    return list(db.scalars(select(ShareLink).where(ShareLink.patient_id == patient_id).order_by(ShareLink.id.desc())))


def last_opened(db: Session, share_id: int) -> datetime | None:
    """Return when a link was opened last, None when it never was."""
    newest = db.scalar(select(func.max(ShareVisit.expires)).where(ShareVisit.share_id == share_id))
    return None if newest is None else newest - VISIT


def find_share(db: Session, share_id: int) -> ShareLink:
    """Return one of the clinic's links; its patient is visible and not deleted."""
    link = own_row(db, ShareLink, share_id, Text("sharing-no-link", link=share_id))
    find_patient(db, link.patient_id)
    return link


def revoke_share(db: Session, link: ShareLink) -> None:
    """End a link and every visit of it."""
    if link.revoked is not None:
        raise Conflict(Text("sharing-link-revoked"))
    link.revoked = utc_now()
    db.flush()


def share_state(link: ShareLink) -> ShareState:
    """Return whether a link can be opened, and if not, why."""
    if link.revoked is not None:
        return "revoked"
    if link.expires <= utc_now():
        return "over"
    return "dead" if link.wrong_pins >= MOST_WRONG_PINS else "open"


def count_try(db: Session, token: str) -> ShareLink | None:
    """Count a try at the PIN of a link before it is checked; None when there is no such link that can be opened."""
    link = db.scalar(select(ShareLink).where(ShareLink.token_hash == _hash(token)))
    if link is None or share_state(link) != "open" or not _may_be_shared(db, link):
        return None
    link.wrong_pins += 1
    db.flush()
    return link


def begin_visit(db: Session, share_id: int) -> str | None:
    """Take the try back, and let the browser read; return its token, or None when the link has ended meanwhile."""
    link = db.get_one(ShareLink, share_id)
    link.wrong_pins -= 1
    if share_state(link) != "open" or not _may_be_shared(db, link):
        return None
    link.openings += 1
    token = secrets.token_urlsafe(TOKEN_BYTES)
    db.add(ShareVisit(share_id=share_id, token_hash=_hash(token), expires=utc_now() + VISIT))
    db.flush()
    return token


def take_back_try(db: Session, share_id: int) -> None:
    """Remove a try that was not checked."""
    db.get_one(ShareLink, share_id).wrong_pins -= 1
    db.flush()


def find_visit(db: Session, token: str) -> SharedRecords | None:
    """Return what the browser with this token may read; None for nothing, or nothing any more."""
    link = db.scalar(
        select(ShareLink)
        .join(ShareVisit, ShareVisit.share_id == ShareLink.id)
        .where(ShareVisit.token_hash == _hash(token), ShareVisit.expires > utc_now())
    )
    if link is None or share_state(link) in {"revoked", "over"} or not _may_be_shared(db, link):
        return None
    return SharedRecords(link.id, link.patient_id, link.session_id, link.expires)


def _may_be_shared(db: Session, link: ShareLink) -> bool:
    """Return whether the patient is there and consents to sharing still."""
    patient = db.get(Patient, link.patient_id)
    return patient is not None and patient.deleted is None and has_consented(db, link.patient_id, "sharing")
