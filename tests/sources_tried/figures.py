"""What a tried source came to: taps, times, ages, processor; as lines of a table, and as a part of a page."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

LONGEST_DELAY = 2.0  # s
DELAY_STEP = 0.005  # s
HEADING = "\n## From `make demo` to the goal\n"
HEAD = """Made by `make sources-tried`; do not edit. A scripted person, whom the emulator of each source measures, does
what the pages ask for: calibrates by the ordinary steps, and drives the straight corridor, in Chromium on this machine.
{day}, commit {commit}, {machine}.
"""
COLUMNS = (
    *("source", "lamps", "taps", "s to the first metre", "age p50, ms", "p99, ms", "delay, ms", "correlation"),
    *("web, %", "control, %", "browser, %", "came to"),
)
FOOT = """
- **Taps** and **seconds**: from the start of `make demo`, installed, until the chair has driven a metre. The task is
  chosen by its address, without a tap. What is typed is no tap.
- **Age**: of the newest frame, as the live picture has it while the chair may move.
- **Delay**: by which the calibration's signals follow the person's movement; of the camera, from the picture to the
  tick. **Correlation**: of both at this delay.
- **Processor**: while the chair drives, of one processor: web process, control process, and all of the page's browser,
  which draws in software, three pictures a second.
"""


class Course(NamedTuple):
    """Numbers at rising times (s)."""

    t: Sequence[float]
    values: Sequence[float]


class Likeness(NamedTuple):
    """How one course follows another."""

    delay: float  # s
    correlation: float
    slope: float  # of the later one over the earlier one


@dataclass
class Tried:
    """What trying one source came to; NaN or None: it did not come so far."""

    name: str
    lamps: int = 0  # that were good
    taps: int = 0
    seconds: float = math.nan  # from `make demo` to the first metre
    ages: Sequence[float] = field(default_factory=list)  # s, of the newest frame
    likeness: Likeness | None = None
    shares: dict[str, float] = field(default_factory=dict)  # of a processor, while the chair drives
    came_to: str = ""  # beside the goal, such as a known angle against the measured one
    stopped: str = ""  # where and why it went no further; empty: the goal was reached

    @property
    def is_good(self) -> bool:
        """Whether the goal was reached."""
        return not self.stopped


def likeness_of(sent: Course, seen: Course) -> Likeness | None:
    """Return how `seen` follows `sent`, at the delay at which both are most alike; None where one of them is constant.

    Numbers of `seen` that are not finite are left out.
    """
    t, values = np.array(seen.t, dtype=np.float64), np.array(seen.values, dtype=np.float64)
    t, values = t[np.isfinite(values)], values[np.isfinite(values)]
    if len(t) < 3 or np.ptp(values) == 0.0 or len(sent.t) == 0 or np.ptp(sent.values) == 0.0:
        return None
    best: Likeness | None = None
    for delay in np.arange(0.0, LONGEST_DELAY, DELAY_STEP).tolist():
        earlier = np.interp(t - delay, sent.t, sent.values)
        spread = float(np.std(earlier))
        if spread == 0.0:
            continue
        covariance = float(np.mean((earlier - earlier.mean()) * (values - values.mean())))
        correlation = covariance / (spread * float(np.std(values)))
        if best is None or abs(correlation) > abs(best.correlation):
            best = Likeness(delay, correlation, covariance / spread**2)
    return best


def table(all_tried: Sequence[Tried]) -> str:
    """Return the table of what was tried."""
    return "".join((line(COLUMNS), f"|{'---|' * len(COLUMNS)}\n", *map(row, all_tried)))


def row(tried: Tried) -> str:
    """Return the line of a source."""
    p50, p99 = (_milliseconds(float(np.percentile(tried.ages, part))) if tried.ages else "–" for part in (50, 99))
    likeness = tried.likeness
    cells = [
        *(tried.name, f"{tried.lamps}", f"{tried.taps}"),
        "–" if math.isnan(tried.seconds) else f"{tried.seconds:.0f}",
        *(p50, p99),
        "–" if likeness is None else _milliseconds(likeness.delay),
        "–" if likeness is None else f"{abs(likeness.correlation):.2f}",
        *(f"{100 * tried.shares[name]:.0f}" if name in tried.shares else "–" for name in ("web", "control", "browser")),
        "; ".join(filter(None, ["goal" if tried.is_good else f"**{tried.stopped}**", tried.came_to])),
    ]
    return line(cells)


def section(all_tried: Sequence[Tried], left_out: Sequence[str], day: str, commit: str, machine: str) -> str:
    """Return the part of the page, with its heading."""
    missing = f"\nNot tried, without its library: {', '.join(left_out)}.\n" if left_out else ""
    head = HEAD.format(day=day, commit=commit, machine=machine)
    return "".join((HEADING, head, "\n", table(all_tried), missing, FOOT))


def section_of(page: str) -> str:
    """Return this part of a page with its heading; empty where the page has none."""
    _, heading, content = page.partition(HEADING)
    return heading + content


def with_section(page: str, part: str) -> str:
    """Return a page with this part at its end, in place of the one before; without a page, one that begins with it."""
    return (page.partition(HEADING)[0] or "# Drivers, measured\n") + part


def _milliseconds(seconds: float) -> str:
    return f"{1000 * seconds:.0f}"


def line(cells: Sequence[str]) -> str:
    """Return a line of a table."""
    return f"| {' | '.join(' '.join(cell.replace('|', '/').split()) for cell in cells)} |\n"
