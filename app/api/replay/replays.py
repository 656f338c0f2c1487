"""The open replays of trials in 3D, each with a server of its own for the person who opened it."""

import secrets
import threading
from collections.abc import Callable
from dataclasses import dataclass

from app.refusals import NotFound
from app.scene.replay import Replay
from app.texts import Text

MOST = 2  # open at once: each draws a whole building. A further one closes the least recently used


@dataclass(frozen=True, slots=True)
class OpenReplay:
    """A replay and the person who opened it."""

    person_id: int
    replay: Replay


class Replays:
    """Opens, finds and closes replays. Thread-safe."""

    def __init__(self) -> None:
        self._open: dict[str, OpenReplay] = {}  # the most recently used last
        self._lock = threading.Lock()

    def add(self, person_id: int, make: Callable[[], Replay]) -> str:
        """Open a replay and return its random id."""
        while self._close_one_of(MOST):
            pass
        word = secrets.token_urlsafe(16)
        replay = OpenReplay(person_id, make())
        with self._lock:
            self._open[word] = replay
        return word

    def find(self, word: str, person_id: int) -> Replay:
        """Return a replay of this person; NotFound when there is none, or it was closed."""
        with self._lock:
            opened = self._open.get(word)
            if opened is None or opened.person_id != person_id:
                raise NotFound(Text("api-replay-closed"))
            self._open[word] = self._open.pop(word)
        return opened.replay

    def close(self, word: str, person_id: int) -> None:
        """Close a replay of this person; do nothing when it is closed already."""
        with self._lock:
            opened = self._open.get(word)
            if opened is None or opened.person_id != person_id:
                return
            del self._open[word]
        opened.replay.stop()

    def close_of(self, person_id: int) -> None:
        """Close all replays of a person whose rights have changed."""
        with self._lock:
            ended = [word for word, replay in self._open.items() if replay.person_id == person_id]
        for word in ended:
            self.close(word, person_id)

    def close_all(self) -> None:
        """Close all replays, because the application ends."""
        while self._close_one_of(1):
            pass

    def _close_one_of(self, many: int) -> bool:
        with self._lock:
            if len(self._open) < many:
                return False
            oldest = self._open.pop(next(iter(self._open)))
        oldest.replay.stop()
        return True
