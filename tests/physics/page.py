"""The page docs/physics.md: tables of the random drives, of the castors, and of the built-in dynamics. No MuJoCo."""

import math
import statistics
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from typing import Final, NamedTuple

from physics.built_in import FITTED, Difference
from physics.chair_model import FRICTIONS, MOTOR_LAGS, PhysicalChair
from physics.measures import FELT_CUTOFF, LIFTED, STILL, WINDOW, Outcome

from app.world.dynamics import Wheelchair


class Band(NamedTuple):
    """A quantity that might have to be limited, and the edges between which drives are counted."""

    name: str
    value: Callable[[Outcome], float]
    edges: Sequence[float]
    of_stop: bool = False  # whether wheels count that left the floor after the ending, and not before it


BANDS: Final = (
    Band("acceleration of the set, m/s2", lambda drive: drive.speeds.acceleration, (0.6, 0.8, 1.2, 2.0, 3.0)),
    Band("deceleration of the set, m/s2", lambda drive: drive.speeds.deceleration, (0.8, 1.2, 2.0, 3.0)),
    Band("speed x turn rate of the set, m/s2", lambda drive: drive.speeds.forward * drive.speeds.turn, (1, 2, 3.75)),
    Band("speed when it was stopped, m/s", lambda drive: drive.speed, (0.3, 0.5, 0.8, 1.2, math.inf), of_stop=True),
)


ON_KERB: Final = 0.01  # m: a chair that stands higher, on tyres that give by 6 mm, has climbed a kerb of 20 mm


def drives_table(outcomes: Sequence[Outcome]) -> str:
    """Return a row for each cell: the worst figure of its drives, in brackets their median."""
    head = (
        *("floor", "drives", "way to standstill, m", "time, s", "went on", "roll-back, mm", "deceleration, m/s2"),
        *("jerk, m/s3", "while driving, m/s2", "least load", "wheel off the floor", "tilt, degrees", "tipped over"),
    )
    rows = []
    for cell in dict.fromkeys(drive.cell for drive in outcomes):
        drives = [drive for drive in outcomes if drive.cell == cell]
        row = (
            *(cell, f"{len(drives)}"),
            _worst([drive.stop.distance for drive in drives]),
            _worst([drive.stop.time for drive in drives]),
            f"{sum(math.isnan(drive.stop.time) and not drive.is_tipped for drive in drives)}",
            _worst([1e3 * drive.stop.roll_back for drive in drives], 0),
            _worst([drive.deceleration for drive in drives], 1),
            _worst([drive.jerk for drive in drives], 0),
            _worst([drive.felt_driving for drive in drives], 1),
            f"{100 * min(drive.least_load for drive in drives):.0f} %",
            f"{sum(drive.lifted_driving or drive.lifted_stopping for drive in drives)}",
            _worst([drive.tilt for drive in drives], 1),
            f"{sum(drive.is_tipped for drive in drives)}",
        )
        rows.append(row)
    return table(head, rows)


def bands_table(outcomes: Collection[Outcome]) -> str:
    """Return at which values of a set, or which speed, wheels left the floor: what a limit would have to forbid."""
    rows = []
    for name, value, edges, of_stop in BANDS:
        for low, high in zip((0.0, *edges), edges, strict=False):
            drives = [drive for drive in outcomes if low < value(drive) <= high]
            lifted = sum(drive.lifted_stopping if of_stop else drive.lifted_driving for drive in drives)
            limits = f"above {low:g}" if math.isinf(high) else f"{low:g} to {high:g}"
            tipped = sum(drive.is_tipped for drive in drives)
            rows.append((name, limits, f"{len(drives)}", f"{lifted}", f"{tipped}"))
    return table(("quantity", "value", "drives", "a wheel off the floor", "tipped over"), rows)


def castors_table(drifts: Sequence[Sequence[float]]) -> str:
    """Return the drifts in degrees; each of `drifts` is back and ahead of the physical chair, then of the built-in."""
    back, ahead, built_in_back, built_in_ahead = (_worst(column, 1) for column in zip(*drifts, strict=True))
    rows = [("MuJoCo", back, ahead), ("built-in wheelchair", built_in_back, built_in_ahead)]
    return table(("chair", "to driving backwards, degrees", "to driving ahead, degrees"), rows)


def comparison_table(differences: Mapping[str, Difference]) -> str:
    """Return how far the built-in chairs are from the physical one."""
    head = ("built-in chair", "place, m", "heading, degrees", "place after 5 s, m", "speed later", "turning later")
    rows = [
        (name, f"{place:.2f}", f"{heading:.1f}", f"{soon:.3f}", f"{1e3 * speed:.0f} ms", f"{1e3 * turn:.0f} ms")
        for name, (place, heading, soon, speed, turn) in differences.items()
    ]
    return table(head, rows)


def fit_table(fitted: Mapping[float, Wheelchair]) -> str:
    """Return the parameters of app/world/dynamics.py, and those fitted to each motor lag (s)."""
    head = ("parameter", "now", *(f"motor lag {1e3 * motor_lag:.0f} ms" for motor_lag in fitted))
    chairs = (Wheelchair(), *fitted.values())
    return table(head, [(f"`{name}`", *(f"{getattr(chair, name):.3g}" for chair in chairs)) for name in FITTED])


def page(
    outcomes: Sequence[Outcome],
    steepest: Collection[str],
    drifts: Sequence[Sequence[float]],
    differences: Mapping[str, Difference],
    fitted: Mapping[float, Wheelchair],
    version: str,
) -> str:
    """Return the page; `steepest` are the cells that bands_table counts, `version` is that of MuJoCo."""
    chair = PhysicalChair()
    frictions, lags = (f"{low:g} to {high:g}" for low, high in (FRICTIONS, MOTOR_LAGS))
    return f"""# A chair of another's physics

Made by `make physics` with MuJoCo {version}: simulated, **not a measured chair**. `tests/physics/chair_model.py` has
its masses and lengths with their sources. Left out: anti-tip wheels, suspension, batteries and electronics that give
way, gear play, the edge between a floor and its slope.

Shaper, gate, signed commands and receiver are the program's own. Each drive draws its wishes, its limits (standard,
first chair, highest, or any that are permitted), the friction ({frictions}) and the motors' lag ({lags} s), and ends
with Stop, silence or the chair's switch. Figures are the worst, in brackets the median.

## Random drives
- **Deceleration, jerk**: at the chest, behind a low-pass of {FELT_CUTOFF:g} Hz (Butterworth, second order, causal).
- **Standstill**: first below {STILL:g} m/s and rad/s. **Went on**: sliding, no standstill within 3 s, hence without way
  and time. **Roll-back**: from standstill to the place 3 s after the ending.
- **Least load**: of a wheel's load at rest on that floor, over {WINDOW} ms; **off the floor**: below {LIFTED:g} N. A
  wheel that jumps on the kerb counts too. On it in the end were {_climbed(outcomes)}; some were too slow to reach it.
- **What holds the chair**: motors of up to {chair.largest_torque:g} Nm at each wheel that hold speed 0; parking brakes
  of {chair.brake_torque:g} Nm that close after {chair.brake_delay:g} s of rest in neutral, and open at once.

{drives_table(outcomes)}

### Which limits would keep the wheels down
The drives on 10 degrees. Where a wheel left the floor, a limit of the product has to forbid that value.

{bands_table([drive for drive in outcomes if drive.cell in steepest])}

## Castors that turn round
From a turn on the spot straight back, then straight ahead, standard limits: by how much the heading changes. It depends
on how much a tyre resists twisting (`TWIST_FRICTION`), for which no chair was measured.

{castors_table(drifts)}

## The built-in dynamics on the 28 m path
Commands of a practised simulated person. Root mean squares against MuJoCo on a level floor; *later*: by how much
MuJoCo's chair follows later, link and receiver included.

{comparison_table(differences)}

What `python -m physics --fit` proposes for `app/world/dynamics.py`, from that path and four turns of the castors. No
scene has slopes, so the built-in chairs have none.

{fit_table(fitted)}
"""


def _climbed(outcomes: Sequence[Outcome]) -> str:
    heights = [drive.height for drive in outcomes if "kerb" in drive.cell]
    return f"{sum(height > ON_KERB for height in heights)} of {len(heights)} chairs"


def table(head: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """Return a table in Markdown."""
    titles = list(head)
    return "\n".join(f"| {' | '.join(line)} |" for line in (titles, ["---"] * len(titles), *rows))


def _worst(values: Sequence[float], digits: int = 2) -> str:
    """Return the largest value, and the median in brackets, of those that are known."""
    known = [value for value in values if math.isfinite(value)]
    return f"{max(known):.{digits}f} ({statistics.median(known):.{digits}f})" if known else "none"
