"""Which screens are in view, by their own words."""

from typing import NamedTuple

from app.session.control_link import ScreenSign

SILENCE_LIMIT = 1.0  # s for which a page may stand still before the chair stops: nobody can press Stop on it meanwhile
VIRTUAL_SILENCE_LIMIT = 3.0  # s on the virtual chair, where nobody sits, and a slow screen draws a whole building
LINK_LIMIT = 2.0  # s of silence, after which a socket that was never closed gives way; the chair stops after 0.3 s


class Screen(NamedTuple):
    """A page of somebody who is signed in; the word is its own, random, and told to nobody else."""

    person_id: int
    word: str


class PageSign(NamedTuple):
    """What a page says of itself through its worker."""

    t: float  # monotonic s
    visible: bool
    silence: float  # s for which the page's own thread has said nothing
    link: object  # the socket of the message


class Screens:
    """Keeps what each screen said last. Asked from several threads: each step is one assignment."""

    def __init__(self) -> None:
        self._signs: dict[Screen, PageSign] = {}

    def take(self, screen: Screen, sign: PageSign) -> bool:
        """Store the sign of a screen; return False, and change nothing, while another socket speaks for it.

        Another socket takes over when the first has ended, or was silent for LINK_LIMIT. Otherwise a dead socket that
        was never closed would keep out a page that is loaded again.
        """
        before = self._signs.get(screen)
        if before is not None and before.link is not sign.link and sign.t - before.t < LINK_LIMIT:
            return False
        self._signs[screen] = sign
        return True

    def gone(self, screen: Screen, link: object) -> None:
        """Forget a screen whose socket has ended, unless another socket speaks for it."""
        if screen in self._signs and self._signs[screen].link is link:
            del self._signs[screen]

    def sign(self, screen: Screen, t: float, silence_limit: float) -> ScreenSign:
        """Return the age (s) at `t` of the last sign of a screen, and whether its page is in view, hidden or slow.

        Its page may stand still for `silence_limit` s.
        """
        said = self._signs.get(screen)
        if said is None:
            return ScreenSign()
        age = max(0.0, t - said.t)
        if not said.visible:
            return ScreenSign(age, "hidden")
        return ScreenSign(age, "slow" if said.silence > silence_limit else "in view")

    def age(self, screen: Screen, t: float) -> float | None:
        """Return how long (s) before `t` a screen said that it is in view; None when it is hidden or gone."""
        sign = self.sign(screen, t, SILENCE_LIMIT)
        return None if sign.view == "hidden" else sign.age
