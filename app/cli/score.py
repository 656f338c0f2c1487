"""`bodydrive score`: all path measures of a trajectory in a file."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.common_options import AsJson
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.signal_options import SampleRate, TimeName, TimeUnit, reading_options, signals_refused
from app.scoring.measures import CIRCUMSTANCES, REACHED, REACHED_NAME, TRIAL_MEASURES
from app.texts import Text
from app.world.tasks import GOAL_RADIUS

if TYPE_CHECKING:
    from app.scoring.path_measures import Measures
    from app.signals.signals import ReadingOptions

EXTRAS = ("in_contact", "contacts", "u1", "u2")  # optional columns of the trajectory that give further measures
LARGEST_RADIUS = 1000.0  # m
FARTHEST = 1e8  # m: map coordinates are smaller
LONGEST = 86_400.0  # s between the first row and the last
SLOWEST_ROWS = 2.0  # s, the usual time between two rows of a recording; more means that t is not in seconds
SLOW_ROWS = 0.5  # s; with such rows, a mean speed below SLOWEST means so, too
SLOWEST = 0.02  # m/s
RECORDING = 20  # rows; fewer may be written by hand, with any time between them
FASTEST = 10.0  # m/s, mean speed; more means that x and y are not in metres, or t not in seconds
FOLLOWING = ("dist_ratio", "e_diff", "cross_track_rms", "cross_track_max", "cross_track_mean")  # how well it followed


def score(
    trajectory: Annotated[Path, typer.Argument(metavar="TRAJECTORY", help=help_text("cli-help-score-trajectory"))],
    path: Annotated[Path, typer.Argument(metavar="PATH", help=help_text("cli-help-score-path"))],
    goal_radius: Annotated[float, typer.Option(help=help_text("cli-help-score-goal-radius"))] = GOAL_RADIUS,
    time: TimeName = None,
    unit: TimeUnit = None,
    rate: SampleRate = None,
    as_json: AsJson = False,
) -> None:
    """Score a driven trajectory against a prescribed path; s and m."""
    if not 0 < goal_radius <= LARGEST_RADIUS:
        raise InputError(Text("cli-score-radius", radius=f"{goal_radius:g}", most=f"{LARGEST_RADIUS:g}"))
    measures = score_files(trajectory, path, goal_radius, reading_options(time, unit, rate, None))
    typer.echo(json.dumps(measures) if as_json else _table(measures))


def score_files(
    trajectory: Path, path: Path, goal_radius: float, options: "ReadingOptions | None" = None
) -> "Measures":
    """Return the measures of the trajectory in one file along the path in another; `options` are of the trajectory."""
    import numpy as np

    from app.scoring.path_measures import path_measures
    from app.signals.signals import AS_THE_FILE_SAYS
    from app.signals.trajectory_files import read_places, read_trajectory
    from app.world.path import Path as Line

    try:
        said = options or AS_THE_FILE_SAYS
        t, x, y, extras = read_trajectory(trajectory, EXTRAS, said.time, said.unit, said.rate)
        points = read_places(path)
    except ValueError as error:
        raise signals_refused(error) from error
    for file, places in ((trajectory, (x, y)), (path, points)):
        if np.abs(places).max() > FARTHEST:
            raise InputError(Text("cli-score-places", file=str(file), most=f"{FARTHEST:g}"))
    if np.ptp(t) > LONGEST:
        raise InputError(Text("cli-score-too-long", file=str(trajectory), seconds=f"{np.ptp(t):g}"))
    try:
        Line(points.tolist())
    except ValueError as error:
        raise InputError(Text("cli-named", name=str(path), text=error)) from error
    try:
        measures = path_measures(t, x, y, points, goal_radius, **extras)
    except ValueError as error:
        raise InputError(Text("cli-named", name=str(trajectory), text=error)) from error
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
        raise InputError(Text("cli-score-rows", file=str(trajectory), seconds=f"{rows:g}"))
    speed = measures["mean_speed"]
    if speed is not None and rows >= SLOW_ROWS and 0.0 < speed < SLOWEST:
        seconds = f"{rows:g}"
        raise InputError(Text("cli-score-slow", file=str(trajectory), speed=f"{speed:.2g}", seconds=seconds))
    if speed is not None and speed > FASTEST:
        raise InputError(Text("cli-score-speed", file=str(trajectory), speed=f"{speed:g}"))


def _table(measures: "Measures") -> str:
    measures_by_name = TRIAL_MEASURES | CIRCUMSTANCES
    lines = [
        f"{REACHED_NAME!s:<44} {_written(value)}"
        if name == REACHED
        else f"{measures_by_name[name].name!s:<44} {_written(value)} {measures_by_name[name].unit}".rstrip()
        for name, value in measures.items()
    ]
    return "\n".join([*lines, "", str(Text("cli-score-loops"))])


def _written(value: float | bool | None) -> str:
    if value is None:
        return "-"
    if isinstance(value, bool):
        return str(Text("cli-yes" if value else "cli-no"))
    return str(value) if isinstance(value, int) else f"{value:.3f}"
