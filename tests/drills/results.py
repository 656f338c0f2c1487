"""The results of drills, as a table."""

import threading
from dataclasses import dataclass, field
from pathlib import Path

from app.clock import monotonic


@dataclass
class Result:
    """All runs of one drill; times in s from the injury."""

    drill: str
    limit: float | None  # s until the stop begins
    disarm_limit: float | None = None  # s until the chair is disarmed
    begun: list[float] = field(default_factory=list)
    disarmed: list[float] = field(default_factory=list)
    late: list[float] = field(default_factory=list)  # s of lateness of this machine during the run
    violations: list[str] = field(default_factory=list)
    runs: int = 0
    remark: str = ""

    def add(self, begun: float | None, disarmed: float | None = None, late: float = 0.0) -> None:
        """Add one run; a time beyond its limit is a violation, unless this machine was late by the difference."""
        self.runs += 1
        self.late.append(late)
        for name, time, times, limit in (
            ("stop begun", begun, self.begun, self.limit),
            ("disarmed", disarmed, self.disarmed, self.disarm_limit),
        ):
            if time is None:
                continue
            times.append(time)
            if limit is not None and time > limit + late:
                self.violations.append(f"run {self.runs}: {name} after {1e3 * time:.0f} ms, limit {1e3 * limit:.0f} ms")

    def violated(self, words: str) -> None:
        """Say what was wrong in the run that is under way."""
        self.violations.append(f"run {self.runs + 1}: {words}")

    def row(self) -> str:
        cells = [
            self.drill,
            str(self.runs),
            _worst(self.begun),
            "" if self.limit is None else f"{1e3 * self.limit:.0f}",
            _worst(self.disarmed),
            "" if self.disarm_limit is None else f"{1e3 * self.disarm_limit:.0f}",
            _worst(self.late),
            f"**{len(self.violations)} violations**: {self.violations[0]}" if self.violations else "kept",
            self.remark,
        ]
        return f"| {' | '.join(cells)} |"


SIDE_BY_SIDE = 4  # chairs of a drill with many runs


def shares(runs, chairs=SIDE_BY_SIDE):
    """Return how many of the runs each of the chairs makes, without chairs that would make none."""
    return [runs // chairs + (i < runs % chairs) for i in range(min(runs, chairs))]


HEAD = """| drill | runs | worst: stop begun, ms | limit | worst: disarmed, ms | limit | machine late, ms | | remark |
|---|---|---|---|---|---|---|---|---|"""


def _worst(times: list[float]) -> str:
    return f"{1e3 * max(times):.0f}" if times else ""


def waited(pid: int) -> float:
    """Return how long (s) a process has waited for a processor since its start; 0 where that is not counted."""
    try:
        return int(Path(f"/proc/{pid}/schedstat").read_text().split()[1]) * 1e-9
    except (OSError, IndexError, ValueError):
        return 0.0


class Watcher:
    """Measures for how long this machine does not run an ordinary thread."""

    EVERY = 0.005  # s
    USUAL = 0.015  # s of lateness that is usual

    def __init__(self) -> None:
        self._gaps: list[tuple[float, float]] = []
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._watch)
        self._thread.start()

    def _watch(self) -> None:
        last = monotonic()
        while not self._ended.wait(self.EVERY):
            now = monotonic()
            if now - last - self.EVERY > self.USUAL:
                self._gaps.append((now, now - last - self.EVERY))
            last = now

    def late(self, begin: float, end: float) -> float:
        """Return the largest lateness (s) between two times."""
        return max((gap for at, gap in self._gaps if at >= begin and at - gap <= end), default=0.0)

    def close(self) -> None:
        self._ended.set()
        self._thread.join()
