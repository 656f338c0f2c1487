"""What a chair, and the output that drives it, report of themselves. Standard library only."""

import math
from typing import NamedTuple

from app.hardware.chair.packet import DIGEST_BYTES
from app.hardware.chair.reasons import Reason


class TableReport(NamedTuple):
    """By which chair document an output makes deflections of a joystick out of speeds."""

    digest: bytes = bytes(DIGEST_BYTES)  # the first bytes of the document's SHA-256; zeros: there is none
    is_crawling: bool = False  # whether one is missing, so that a crawl is commanded at most


NO_TABLE = TableReport()  # of an output that commands speeds, and needs no document


class ChairReadings(NamedTuple):
    """What a chair reports of itself; each field is optional."""

    v: float = math.nan  # m/s, measured; NaN: not measured
    omega: float = math.nan  # rad/s
    battery: float = math.nan  # 0..1
    own_joystick: bool = False  # whether somebody moves the chair's own joystick
    trouble: Reason = Reason.NONE  # why the chair cannot be driven now

    @property
    def obstacle(self) -> Reason:
        """Why the chair is not driven now; NONE when nothing stands against it."""
        return Reason.OWN_JOYSTICK if self.own_joystick else self.trouble


NO_READINGS = ChairReadings()  # of a chair that reports nothing
