"""Replays of trials in 3D: a few servers of their own, each for the person who opened it."""

import secrets
import threading
from collections.abc import Callable
from dataclasses import dataclass

from app.refusals import NotFound
from app.scene.replay import Replay

MOST = 2  # at once on this machine: each draws a whole building; the one not looked at for longest gives way


@dataclass(frozen=True, slots=True)
class OpenReplay:
    """A replay and whose it is."""

    person_id: int
    replay: Replay


class Replays:
    """Opens, finds and closes them; from any thread."""

    def __init__(self) -> None:
        self._open: dict[str, OpenReplay] = {}  # the one that was looked at last, last
        self._lock = threading.Lock()

    def add(self, person_id: int, make: Callable[[], Replay]) -> str:
        """Open a replay and return its word."""
        while self._close_one_of(MOST):
            pass
        word = secrets.token_urlsafe(16)
        made = OpenReplay(person_id, make())
        with self._lock:
            self._open[word] = made
        return word

    def find(self, word: str, person_id: int) -> Replay:
        """Return a replay of this person; NotFound when there is none (any more)."""
        with self._lock:
            found = self._open.get(word)
            if found is None or found.person_id != person_id:
                raise NotFound("This replay was closed: open it again.")
            self._open[word] = self._open.pop(word)
        return found.replay

    def close(self, word: str, person_id: int) -> None:
        """Close a replay of this person; one that is closed already stays so."""
        with self._lock:
            found = self._open.get(word)
            if found is None or found.person_id != person_id:
                return
            del self._open[word]
        found.replay.stop()

    def close_all(self) -> None:
        """Close all: the application ends."""
        while self._close_one_of(1):
            pass

    def _close_one_of(self, many: int) -> bool:
        with self._lock:
            if len(self._open) < many:
                return False
            oldest = self._open.pop(next(iter(self._open)))
        oldest.replay.stop()
        return True
