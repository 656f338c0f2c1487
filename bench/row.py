"""One measured figure beside its target."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from statistics import median
from typing import Literal

from app.pipeline.compiled import IS_COMPILED


def reach_of(pure: float, compiled: float) -> float:
    """Return the target of what runs: plain Python, or the compiled middle of the program."""
    return compiled if IS_COMPILED else pure


@dataclass(slots=True)
class Row:
    """A line of the benchmark's table."""

    what: str
    runs: Sequence[float]  # the figure of each run
    unit: str  # "x": a ratio to something else that the same machine did in the same run
    reach: float | None  # the target; None: no target
    better: Literal["lower", "higher"]
    details: str
    of_runs: Callable[[Sequence[float]], float] = median

    @property
    def figure(self) -> float:
        """The figure of all runs together."""
        return self.of_runs(self.runs)

    @property
    def is_ratio(self) -> bool:
        """Whether the figure hardly depends on how fast the machine is."""
        return self.unit == "x"

    @property
    def is_reached(self) -> bool:
        """Whether the figure meets its target."""
        if self.reach is None:
            return True
        return self.figure <= self.reach if self.better == "lower" else self.figure >= self.reach
