"""Reads a trajectory in the plane from a file: columns x and y, or what robots and their data sets write.

TUM rows are `timestamp tx ty tz qx qy qz qw`, KITTI rows the 3 x 4 matrix of a camera's pose (x to the right, y down,
z ahead) with the times in `times.txt` beside them; a header of EuRoC or of a bag's CSV names the place in longer words.
"""

from collections.abc import Collection, Sequence
from pathlib import Path
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.signals.column_names import columns_of_channels, words_of
from app.signals.columns import named_columns, read_table
from app.signals.csv_dialect import cells_of
from app.signals.file_table import FileTable
from app.signals.time_columns import time_of_table
from app.signals.time_names import time_names
from app.texts import Text

X: Final = "x"
Y: Final = "y"
UNNAMED: Final = "column_"
POSITION: Final = frozenset(("position", "pos", "p", "translation", "trans", "location", "loc"))  # in names of places
JOINED: Final = {X: ("tx", "px", "posx", "xpos"), Y: ("ty", "py", "posy", "ypos")}
METRES: Final = {"m": 1.0, "mm": 1e-3, "cm": 1e-2, "km": 1e3, "in": 0.0254, "inch": 0.0254}  # m of each unit
TUM: Final = 8  # numbers of a row
KITTI: Final = 12
AHEAD: Final = 11  # of the numbers of a row of KITTI
RIGHT: Final = 3
TIMES_OF_KITTI: Final = "times.txt"
DESCRIPTION: Final = "metadata.yaml"  # of a bag of ROS 2, in its folder
TOLERANCE: Final = 1e-2  # of a rotation's length, for what is rounded


class PlanarTrajectory(NamedTuple):
    """Places over time, with further columns of the file."""

    t: NDArray[np.float64]  # (n,) s
    x: NDArray[np.float64]  # (n,) m
    y: NDArray[np.float64]  # (n,) m
    extras: dict[str, NDArray[np.float64]]


def read_trajectory(
    path: Path,
    extras: Collection[str] = (),
    time: str | None = None,
    unit: str | None = None,
    rate: float | None = None,
) -> PlanarTrajectory:
    """Return the trajectory in a file, or in the folder of a bag.

    Parameters
    ----------
    path : Path
        The file or folder.
    extras : collection of str
        Further columns, where the file has them.
    time, unit : str, optional
        Which column is the time, and in which unit it is, where the file says it wrongly.
    rate : float, optional
        Hz, of rows without times.

    Raises
    ------
    ValueError
        One sentence that names the file, the line or column, and what to do.
    """
    path = _storage_of(path)
    names = [*named_columns(path).names]
    if all(name.startswith(UNNAMED) for name in names) and len(names) in {TUM, KITTI}:
        known = _of_data_set(path, read_table(path), rate)
        if known is not None:
            return known
    times = [time] if time is not None else time_names(names)
    places = _place_columns(path, names, times)
    others = columns_of_channels(list(extras), [name for name in names if name not in {*times, *places}])
    wanted = {*places, *others.values()}
    table = read_table(path, only={*times, *wanted} if times else None)
    if rate is not None and time is None:
        t = np.arange(len(table.columns[places[0]])) / rate
    else:
        t = time_of_table(table, time, unit, wanted).t
    x, y = (_in_metres(table, column) for column in places)
    return PlanarTrajectory(t, x, y, {name: table.numbers(column) for name, column in others.items()})


def read_places(path: Path) -> NDArray[np.float64]:
    """Return the points (n, 2) of a line in m: columns x and y, or the first two of a table without names.

    Raises
    ------
    ValueError
        One sentence that names the file, the line or column, and what to do.
    """
    names = [*named_columns(path).names]
    unnamed = len(names) == 2 and all(name.startswith(UNNAMED) for name in names)
    columns = (names[0], names[1]) if unnamed else _place_columns(path, names, [])
    table = read_table(path, only=columns)
    return np.column_stack([_in_metres(table, column) for column in columns])


def _storage_of(path: Path) -> Path:
    """Return the file in the folder of a bag of ROS 2; any other path is returned as it is."""
    if not (path / DESCRIPTION).is_file():
        return path
    files = sorted(file for file in path.iterdir() if file.suffix in {".mcap", ".db3"})
    return files[0] if files else path


def _place_columns(path: Path, names: Sequence[str], times: Collection[str]) -> tuple[str, str]:
    """Return the columns of x and y; raise ValueError where there are none, or several."""
    others = [name for name in names if name not in times]
    found = {
        axis: [name for name in others if words_of(name) == (axis,)]
        or [name for name in others if _is_place(words_of(name), axis)]
        for axis in (X, Y)
    }
    if len(found[X]) == len(found[Y]) == 1:
        return found[X][0], found[Y][0]
    file, listing = str(path), ", ".join(names[:6])
    if found[X] and found[Y]:
        raise ValueError(Text("signals-places-several", file=file, names=", ".join([*found[X], *found[Y]][:6])))
    missing = X if not found[X] else Y
    raise ValueError(Text("signals-column-missing", file=file, column=missing, names=listing))


def _is_place(words: Sequence[str], axis: str) -> bool:
    """Return whether the words of a name are those of a place along an axis."""
    if not words:
        return False
    return words[-1] in JOINED[axis] or (words[-1] == axis and bool(POSITION.intersection(words)))


def _in_metres(table: FileTable, column: str) -> NDArray[np.float64]:
    return table.numbers(column) * METRES.get(table.units.get(column, "m").lower(), 1.0)


def _of_data_set(path: Path, table: FileTable, rate: float | None) -> PlanarTrajectory | None:
    """Return the trajectory of rows of TUM or KITTI; None when they are neither."""
    rows = np.column_stack([table.numbers(name) for name in table.columns])
    if rows.shape[1] == TUM and np.abs(np.linalg.norm(rows[:, 4:], axis=1) - 1.0).max() < TOLERANCE:
        return PlanarTrajectory(time_of_table(table, next(iter(table.columns))).t, rows[:, 1], rows[:, 2], {})
    if rows.shape[1] != KITTI:
        return None
    rotations = rows.reshape(-1, 3, 4)[:, :, :3]
    if np.abs(rotations @ rotations.transpose(0, 2, 1) - np.eye(3)).max() > TOLERANCE:
        return None
    return PlanarTrajectory(_times_of_kitti(path, table, rate), rows[:, AHEAD], -rows[:, RIGHT], {})


def _times_of_kitti(path: Path, table: FileTable, rate: float | None) -> NDArray[np.float64]:
    """Return the times of the file beside, or those of a given rate; raise ValueError without both."""
    count = len(next(iter(table.columns.values())))
    beside = path.with_name(TIMES_OF_KITTI)
    if rate is not None:
        return np.arange(count) / rate
    if beside.is_file():
        lines = beside.read_text(encoding="utf-8", errors="replace").splitlines()
        times = np.array([float(cells_of(line, " ")[0]) for line in lines if line.strip()])
        if len(times) == count:
            return times
    raise ValueError(Text("signals-kitti-times", file=str(path), count=count))
