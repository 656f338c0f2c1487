"""The clock of a page that sends samples, against ours."""

import math
from typing import Final

CLOCK_DRIFT: Final = 2e-4  # s per s by which the least delay is raised: two clocks of 100 ppm, one too fast, one slow


class PageClock:
    """The clock of one page against ours.

    What the two differ by is unknown, but it does not change: the message that took least time shows it. A delay that
    is there from the first message on cannot be seen in this way; on a local network it is a few milliseconds.
    """

    def __init__(self) -> None:
        self._least = math.inf  # s, the least difference between our clock and the page's
        self._received = 0.0  # monotonic s, when the newest message came

    def age(self, taken_t: float, sent_t: float, received: float) -> float:
        """Return how old (s) a sample was when it came at `received` (monotonic s).

        It was taken at `taken_t` and sent at `sent_t` (s of the page's clock).
        """
        self._least = min(self._least + CLOCK_DRIFT * max(0.0, received - self._received), received - sent_t)
        self._received = received
        return received - self._least - taken_t
