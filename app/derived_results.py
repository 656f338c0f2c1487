"""Results that are derived from what never changes again, such as a closed recording: each one is derived once."""

import threading
from collections.abc import Callable, Hashable, Iterable, Mapping
from typing import Generic, TypeVar

Key = TypeVar("Key", bound=Hashable)
Value = TypeVar("Value")


class DerivedResults(Generic[Key, Value]):
    """Keeps the results that were used last, at most `most` of them, as long as the program runs. Thread-safe.

    A key names everything that its result depends on: the recording, the parameters, the trials that count. It names no
    version of the computation, which is the same as long as the program runs.
    """

    def __init__(self, most: int) -> None:
        self._most = most
        self._results: dict[Key, Value] = {}  # the one that was used last stands last
        self._lock = threading.Lock()

    def of(self, key: Key, derive: Callable[[], Value]) -> Value:
        """Return the result of a key, derived now where it is not stored.

        Two threads that ask at once may both derive it. What `derive` raises is raised, and nothing is kept.
        """
        stored = self.find([key])
        if key in stored:
            return stored[key]
        value = derive()
        self.store({key: value})
        return value

    def find(self, keys: Iterable[Key]) -> dict[Key, Value]:
        """Return the results of those keys that have one; each of them counts as used."""
        with self._lock:
            stored = {key: self._results[key] for key in keys if key in self._results}
            for key in stored:
                self._results[key] = self._results.pop(key)
        return stored

    def store(self, results: Mapping[Key, Value]) -> None:
        """Store results, and forget those that were not used for the longest time where there are too many."""
        with self._lock:
            for key, value in results.items():
                self._results.pop(key, None)
                self._results[key] = value
            while len(self._results) > self._most:
                del self._results[next(iter(self._results))]

    def forget(self, applies: Callable[[Key], bool]) -> None:
        """Forget the results of all keys to which a condition applies, because something has replaced them."""
        with self._lock:
            self._results = {key: value for key, value in self._results.items() if not applies(key)}
