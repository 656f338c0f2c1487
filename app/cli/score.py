"""`bodydrive score`: all path measures of a trajectory in a file."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.common_options import AsJson
from app.cli.errors import InputError
from app.scoring.measures import CIRCUMSTANCES, REACHED, REACHED_NAME, TRIAL_MEASURES

if TYPE_CHECKING:
    from app.scoring.path_measures import Measures

EXTRAS = ("in_contact", "contacts", "u1", "u2")  # optional columns of the trajectory that give further measures
LARGEST_RADIUS = 1000.0  # m
FARTHEST = 1e8  # m: map coordinates are smaller
LONGEST = 86_400.0  # s between the first row and the last
SLOWEST_ROWS = 2.0  # s, the usual time between two rows of a recording; more means that t is not in seconds
RECORDING = 20  # rows; fewer may be written by hand, with any time between them
FASTEST = 10.0  # m/s, mean speed; more means that x and y are not in metres, or t not in seconds
FOLLOWING = ("dist_ratio", "e_diff", "cross_track_rms", "cross_track_max", "cross_track_mean")  # how well it followed

CANCELLING = "Two loops around one place in opposite directions cancel in the area; the distance driven counts both."


def score(
    trajectory: Annotated[Path, typer.Argument(metavar="TRAJECTORY", help="CSV or Parquet with columns t, x, y.")],
    path: Annotated[Path, typer.Argument(metavar="PATH", help="CSV or Parquet with columns x, y: the path's points.")],
    goal_radius: Annotated[float, typer.Option(help="How near the path's end counts as reached, m.")] = 0.5,
    as_json: AsJson = False,
) -> None:
    """Score a driven trajectory against a prescribed path; s and m.

    A drive that ends no further along the path than it began, and not at its goal, has no measures of following. Two
    loops around one place in opposite directions cancel in the area off the path; the distance driven counts both.
    """
    if not 0 < goal_radius <= LARGEST_RADIUS:
        raise InputError(f"--goal-radius {goal_radius:g}: give metres above 0 and at most {LARGEST_RADIUS:g}")
    measures = score_files(trajectory, path, goal_radius)
    typer.echo(json.dumps(measures) if as_json else _table(measures))


def score_files(trajectory: Path, path: Path, goal_radius: float) -> "Measures":
    """Return the measures of the trajectory in one file along the path in another."""
    import numpy as np

    from app.scoring.path_measures import path_measures
    from app.signals.columns import read_columns, require_column
    from app.world.path import Path as Line

    try:
        trajectory_columns = read_columns(trajectory, only=("t", "x", "y", *EXTRAS))
        t, x, y = (require_column(trajectory_columns, trajectory, name) for name in ("t", "x", "y"))
        extras = {
            name: require_column(trajectory_columns, trajectory, name) for name in EXTRAS if name in trajectory_columns
        }
        prescribed = read_columns(path, only=("x", "y"))
        points = np.column_stack([require_column(prescribed, path, name) for name in ("x", "y")])
    except ValueError as error:
        raise InputError(str(error)) from error
    for file, places in ((trajectory, (x, y)), (path, points)):
        if np.abs(places).max() > FARTHEST:
            raise InputError(f"{file}: x and y must be metres, at most {FARTHEST:g} from 0: correct them")
    if np.ptp(t) > LONGEST:
        raise InputError(f"{trajectory}: it lasts {np.ptp(t):g} s, more than a day: give t in seconds, of one trial")
    try:
        Line(points.tolist())
    except ValueError as error:
        raise InputError(f"{path}: {error}") from error
    try:
        measures = path_measures(t, x, y, points, goal_radius, **extras)
    except ValueError as error:
        raise InputError(f"{trajectory}: {error}") from error
    _check_units(trajectory, float(np.median(np.diff(t))) if len(t) >= RECORDING else 0.0, measures)
    line = Line(points.tolist())
    ahead = line.project(float(x[-1]), float(y[-1]))[0] > line.project(float(x[0]), float(y[0]))[0]
    if not measures["reached"] and not ahead:
        # Against its direction a path can be followed exactly: such a drive has no measure of how well it followed.
        measures |= dict.fromkeys(FOLLOWING)
    return measures


def _check_units(trajectory: Path, rows: float, measures: "Measures") -> None:
    """Refuse units that cannot be those of a chair: `rows` is the usual time between two rows (s)."""
    if rows > SLOWEST_ROWS:
        raise InputError(f"{trajectory}: its rows are usually {rows:g} s apart: give t in seconds, not in milliseconds")
    speed = measures["mean_speed"]
    if speed is not None and speed > FASTEST:
        raise InputError(f"{trajectory}: its mean speed is {speed:g} m/s: give x and y in metres, and t in seconds")


def _table(measures: "Measures") -> str:
    measures_by_name = TRIAL_MEASURES | CIRCUMSTANCES
    lines = [
        f"{REACHED_NAME!s:<44} {_written(value)}"
        if name == REACHED
        else f"{measures_by_name[name].name!s:<44} {_written(value)} {measures_by_name[name].unit}".rstrip()
        for name, value in measures.items()
    ]
    return "\n".join([*lines, "", CANCELLING])


def _written(value: float | bool | None) -> str:
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return str(value) if isinstance(value, int) else f"{value:.3f}"
