"""Which screens are in view, by their own words."""

from typing import NamedTuple

from app.session.control import ScreenSign

SILENCE_LIMIT = 1.0  # s for which a page may stand still before the chair stops: nobody can press Stop on it meanwhile
VIRTUAL_SILENCE_LIMIT = 3.0  # s on the virtual chair, where nobody sits, and a slow screen draws a whole building
LINK_LIMIT = 2.0  # s without a word, then a link that never ended gives way; the chair stops after 0.3 s of them


class Screen(NamedTuple):
    """A page of somebody who is signed in; the word is its own, random, and told to nobody else."""

    person_id: int
    word: str


class PageSign(NamedTuple):
    """What a page says of itself through its worker."""

    t: float  # monotonic s
    visible: bool
    silence: float  # s for which the page's own thread has said nothing
    link: object  # over which it was said


class Screens:
    """Keeps what each screen said last. Asked from several threads: each step is one assignment."""

    def __init__(self) -> None:
        self._signs: dict[Screen, PageSign] = {}

    def take(self, screen: Screen, sign: PageSign) -> bool:
        """Take what a screen says; return False, and change nothing, while another link speaks for it.

        Another link takes over when the first has ended, or said nothing for LINK_LIMIT: one that is dead and was
        never closed would otherwise keep the page out for ever when it is loaded again.
        """
        before = self._signs.get(screen)
        if before is not None and before.link is not sign.link and sign.t - before.t < LINK_LIMIT:
            return False
        self._signs[screen] = sign
        return True

    def gone(self, screen: Screen, link: object) -> None:
        """Take a screen out whose link has ended, unless it speaks over another one."""
        if screen in self._signs and self._signs[screen].link is link:
            del self._signs[screen]

    def sign(self, screen: Screen, t: float, silence_limit: float) -> ScreenSign:
        """Return how long (s) before `t` a screen said something, and whether it counts.

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
