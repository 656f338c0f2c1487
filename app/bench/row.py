"""One measured figure beside what is to be reached."""

from dataclasses import dataclass
from typing import Literal


@dataclass(slots=True)
class Row:
    """A line of the benchmark's table."""

    what: str
    figure: float
    unit: str
    reach: float
    better: Literal["lower", "higher"]
    details: str

    @property
    def is_reached(self) -> bool:
        """Whether the figure is where it should be."""
        return self.figure <= self.reach if self.better == "lower" else self.figure >= self.reach
