"""Which screens are in view, by their own words."""

from typing import NamedTuple


class Screen(NamedTuple):
    """A page of somebody who is signed in; the word is its own, random, and told to nobody else."""

    person_id: int
    word: str


class Screens:
    """Keeps when each screen last said that it is in view. Asked from several threads: each step is one assignment."""

    def __init__(self) -> None:
        self._said: dict[Screen, tuple[float | None, object]] = {}  # when (None: hidden), and over which link

    def seen(self, screen: Screen, visible: bool, t: float, link: object) -> None:
        """Take what a screen says at `t` (monotonic s) over `link`; saying that it is hidden counts at once."""
        self._said[screen] = (t if visible else None, link)

    def gone(self, screen: Screen, link: object) -> None:
        """Take a screen out whose link has ended, unless it speaks over a newer one."""
        if screen in self._said and self._said[screen][1] is link:
            del self._said[screen]

    def age(self, screen: Screen, t: float) -> float | None:
        """Return how long (s) before `t` the screen said that it is in view; None when it is hidden or gone."""
        said_at, _ = self._said.get(screen, (None, None))
        return None if said_at is None else max(0.0, t - said_at)
