"""The newest report of each screen: whether its page is in view."""

from typing import NamedTuple

from app.session.control_link import ScreenSign

SILENCE_LIMIT = 1.0  # s for which a page may hang before the chair stops: its Stop button does not work meanwhile
VIRTUAL_SILENCE_LIMIT = 3.0  # s on the virtual chair, where nobody sits: a slow screen may take long to draw a building
LINK_LIMIT = 2.0  # s without a report, after which another socket takes over; the chair stops after 0.3 s


class Screen(NamedTuple):
    """A page of a person who is signed in; `word` is its random id, which only the page knows."""

    person_id: int
    word: str


class PageSign(NamedTuple):
    """A report of a page, sent by its worker."""

    t: float  # monotonic s
    visible: bool
    silence: float  # s for which the page's main thread has sent nothing to the worker
    link: object  # the socket that sent the report


class Screens:
    """Keeps the newest report of each screen. Thread-safe, because each change is one assignment."""

    def __init__(self) -> None:
        self._signs: dict[Screen, PageSign] = {}

    def report(self, screen: Screen, sign: PageSign) -> bool:
        """Store the report of a screen; return False, and store nothing, while another socket reports for it.

        Another socket takes over when the first has ended, or has sent nothing for LINK_LIMIT. Without that limit, a
        dead socket that was never closed would shut out a page that is loaded again.
        """
        before = self._signs.get(screen)
        if before is not None and before.link is not sign.link and sign.t - before.t < LINK_LIMIT:
            return False
        self._signs[screen] = sign
        return True

    def remove(self, screen: Screen, link: object) -> None:
        """Forget a screen whose socket has ended, unless another socket reports for it."""
        if screen in self._signs and self._signs[screen].link is link:
            del self._signs[screen]

    def sign(self, screen: Screen, t: float, silence_limit: float) -> ScreenSign:
        """Return the age (s) at `t` of the last report of a screen, and whether its page is in view, hidden or slow.

        A page is slow when its main thread has hung for longer than `silence_limit` s.
        """
        last = self._signs.get(screen)
        if last is None:
            return ScreenSign()
        age = max(0.0, t - last.t)
        if not last.visible:
            return ScreenSign(age, "hidden")
        return ScreenSign(age, "slow" if last.silence > silence_limit else "in view")

    def age(self, screen: Screen, t: float) -> float | None:
        """Return the age (s) at `t` of the last report of a screen; None when its page is hidden or gone."""
        sign = self.sign(screen, t, SILENCE_LIMIT)
        return None if sign.view == "hidden" else sign.age
