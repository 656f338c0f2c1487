"""One measured figure beside what is to be reached."""

from dataclasses import dataclass
from typing import Literal


@dataclass(slots=True)
class Row:
    """A line of the benchmark's table."""

    what: str
    figure: float
    unit: str
    reach: float | None  # None: nothing was asked for
    better: Literal["lower", "higher"]
    details: str

    @property
    def is_reached(self) -> bool:
        """Whether the figure is where it should be."""
        if self.reach is None:
            return True
        return self.figure <= self.reach if self.better == "lower" else self.figure >= self.reach
