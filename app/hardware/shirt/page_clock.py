"""The clock of a page that sends samples, against ours."""

import math
from typing import Final

from app.hardware.shirt.frame_order import FORGIVEN

LONGEST_PAGE: Final = 1e9  # s that a page may have been open
TOO_OLD: Final = 0.5  # s between the taking of a sample and its arrival: an older one shows a body of the past
FORGOTTEN: Final = 2.0  # s without a message: the page was asleep, and its clock may have stood meanwhile


class PageClock:
    """The clock of one page against ours.

    What the two differ by is unknown, but it does not change: the message that took least time shows it. A delay that
    is there from the first message on cannot be seen in this way; on a local network it is a few milliseconds. After a
    silence the clocks are compared anew, because browsers stop the clock of a page while its device sleeps.
    """

    def __init__(self) -> None:
        self._least = math.inf  # s, the least difference between our clock and the page's
        self._received = -math.inf  # monotonic s, when the newest message came

    def age(self, taken_t: float, sent_t: float, received: float) -> float:
        """Return how old (s) a sample was when it came at `received` (monotonic s).

        It was taken at `taken_t` and sent at `sent_t` (s of the page's clock).
        """
        passed = max(0.0, received - self._received)
        least = math.inf if passed > FORGOTTEN else self._least + FORGIVEN * passed
        self._least = min(least, received - sent_t)
        self._received = received
        return received - self._least - taken_t
