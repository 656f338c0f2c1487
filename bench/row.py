"""One measured figure beside its target."""

from dataclasses import dataclass
from typing import Literal


@dataclass(slots=True)
class Row:
    """A line of the benchmark's table."""

    what: str
    figure: float
    unit: str
    reach: float | None  # the target; None: no target
    better: Literal["lower", "higher"]
    details: str

    @property
    def is_reached(self) -> bool:
        """Whether the figure meets its target."""
        if self.reach is None:
            return True
        return self.figure <= self.reach if self.better == "lower" else self.figure >= self.reach
