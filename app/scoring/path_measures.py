"""Measures of one trial along a path: distance, area between trajectory and path, deviation, time, smoothness."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.scoring.stops_and_pulses import onsets, reversals, standstills
from app.texts import Text
from app.world.contacts import contact_rows
from app.world.path import Path
from app.world.progress import LineProgress
from app.world.tasks import GOAL_RADIUS

Numbers = NDArray[np.float64]
Measures = dict[str, float | int | bool | None]

SPACING = 0.25  # m; progress along the path is updated in steps no longer than this
HIGHEST_RATE = 100.0  # Hz, at which the speed is sampled at most
LOWEST_RATE = 20.0  # Hz, twice the highest frequency of SPARC

# Of the area between trajectory and path.
MOST_POINTS = 2000  # a longer trajectory is simplified first
TOLERANCE = 1e-4  # m, largest deviation of the simplified trajectory: an error of at most 0.0001 m2 per metre driven
GRID = 1e-7  # m, to which crossings are rounded, so that nearly equal lines cut each other cleanly
ZERO = 1e-12  # m; smaller coordinates are set to 0
BLOCK = 64  # faces, of neighbouring y, that are computed together

# Of the smoothness.
PAD_LEVEL = 4  # zeros are appended, so that the spectrum is sampled 2 ** 4 times as finely
HIGHEST_FREQUENCY = 10.0  # Hz
LEAST_JERK = 1e-6  # dimensionless; a movement from rest to rest has more than 10, rounding errors alone have less
THRESHOLD = 0.05  # of the spectrum's maximum; frequencies beyond the last one above the threshold are noise


class Cut(NamedTuple):
    """A trajectory from its start to the goal; `last` is the last row of the whole trajectory that is in it."""

    t: Numbers  # (n,) s
    points: Numbers  # (n, 2) m
    last: int
    reached: bool


def path_measures(
    t: ArrayLike,
    x: ArrayLike,
    y: ArrayLike,
    path_points: Sequence[Sequence[float]] | Numbers,
    goal_radius: float = GOAL_RADIUS,
    *,
    in_contact: ArrayLike | None = None,
    contacts: ArrayLike | None = None,
    u1: ArrayLike | None = None,
    u2: ArrayLike | None = None,
    permitted: ArrayLike | None = None,
    restart: ArrayLike | None = None,
) -> Measures:
    """Return the measures of a trial, from its start to where it first reaches the goal.

    Parameters
    ----------
    t
        (n,) s, never decreasing.
    x, y
        (n,) m.
    path_points
        (m, 2) m.
    goal_radius
        m around the path's end.
    in_contact
        (n,) whether the chair touched something.
    contacts
        (n,) number of contacts up to each row; computed from `in_contact` when not given.
    u1, u2
        (n,) controls, -1..1.
    permitted
        (n,) whether motion was permitted since the row before; only such time counts. Everywhere when not given.
    restart
        (n,) whether the chair has not moved since an interruption: no part of the speed's profile, and no stop.

    Returns
    -------
    dict
        dist, path_length (m), dist_ratio, e_diff (m2), cross_track_rms, cross_track_max (the largest distance),
        cross_track_mean (signed, left positive; m, mean of the rows), time (s), mean_speed (m/s), stops, sparc, ldlj,
        reached; collisions and contact_time (s) with `in_contact`; turn_reversals with u2; pulses_per_metre with u1 or
        u2. None where a measure has no value, such as the smoothness of a chair that stood.

    Raises
    ------
    ValueError
        When nothing was driven, lengths differ, a number is not finite, or time goes backwards.
    """
    times, points = _checked(t, x, y)
    path = Path(path_points if isinstance(path_points, Sequence) else path_points.tolist())
    cut = cut_at_goal(times, points, path, goal_radius)
    counts = np.ones(len(cut.t), bool) if permitted is None else _until(cut, "permitted", permitted, len(times))
    counts = counts if counts.any() else ~counts
    waits = np.zeros(len(cut.t), bool) if restart is None else _until(cut, "restart", restart, len(times))
    speed, rate = _speed(cut, waits)
    steps = np.hypot(*np.diff(cut.points, axis=0).T)
    dist = float(steps.sum())
    time = float(np.diff(cut.t)[counts[1:]].sum())
    cross_track = np.array([path.project(px, py)[1] for px, py in cut.points[counts].tolist()])
    measures: Measures = {
        "dist": dist,
        "path_length": path.length,
        "dist_ratio": dist / path.length,
        "e_diff": area_between(cut.points, np.array(path.points)),
        "cross_track_rms": float(np.sqrt(np.mean(cross_track**2))),
        "cross_track_max": float(np.max(np.abs(cross_track))),
        "cross_track_mean": float(np.mean(cross_track)),
        "time": time,
        "mean_speed": float(steps[counts[1:]].sum()) / time if time > 0 else None,
        "stops": standstills(speed, rate),
        "sparc": sparc(speed, rate),
        "ldlj": log_dimensionless_jerk(speed, rate),
        "reached": cut.reached,
    }
    return measures | _contact_measures(cut, times, in_contact, contacts) | _control_measures(cut, times, dist, u1, u2)


def _contact_measures(cut: Cut, t: Numbers, in_contact: ArrayLike | None, contacts: ArrayLike | None) -> Measures:
    measures: Measures = {}
    if in_contact is not None:
        touching = _column("in_contact", in_contact, len(t))[: cut.last + 1] != 0
        measures["collisions"] = len(contact_rows(touching, t[: cut.last + 1]))
        measures["contact_time"] = float(np.diff(t[: cut.last + 1])[touching[1:]].sum())
    if contacts is not None:
        measures["collisions"] = int(_column("contacts", contacts, len(t))[: cut.last + 1].max())
    return measures


def _control_measures(cut: Cut, t: Numbers, dist: float, u1: ArrayLike | None, u2: ArrayLike | None) -> Measures:
    columns = {name: u for name, u in (("u1", u1), ("u2", u2)) if u is not None}
    controls = {name: _column(name, u, len(t))[: cut.last + 1] for name, u in columns.items()}
    measures: Measures = {}
    if "u2" in controls:
        measures["turn_reversals"] = reversals(controls["u2"])
    if controls:
        pulses = sum(onsets(control) for control in controls.values())
        measures["pulses_per_metre"] = pulses / dist if dist > 0 else None
    return measures


def _until(cut: Cut, name: str, values: ArrayLike, n: int) -> NDArray[np.bool_]:
    """Return a column of `n` truth values for the rows of a cut, whose last one may lie before a row of the column."""
    column = _column(name, values, n) != 0
    return np.asarray(column[np.minimum(np.arange(len(cut.t)), n - 1)])


def _speed(cut: Cut, waits: NDArray[np.bool_]) -> tuple[Numbers, float]:
    """Return the speed (n,) in m/s at evenly spaced times without the time of `waits` (n,), and their rate (Hz)."""
    steps = np.diff(cut.t, prepend=cut.t[:1])
    joined = np.cumsum(np.where(waits, 0.0, steps)) if waits.any() else cut.t
    t, first = np.unique(joined, return_index=True)
    if len(t) < 2:
        return np.zeros(0), HIGHEST_RATE
    rate = float(np.clip(1.0 / np.median(np.diff(t)), LOWEST_RATE, HIGHEST_RATE))
    even = t[0] + np.arange(int((t[-1] - t[0]) * rate + 1e-6) + 1) / rate
    if len(even) < 2:
        return np.zeros(0), rate
    even_x, even_y = (np.interp(even, t, cut.points[first, axis]) for axis in (0, 1))
    return np.asarray(np.hypot(np.diff(even_x), np.diff(even_y)) * rate), rate


def area_between(trajectory: Numbers, path: Numbers) -> float:
    """Return E_diff: the area (m2) between `trajectory` (n, 2) and `path` (m, 2), both in m and from start to end.

    The trajectory, followed by the path backwards, makes one closed ring. Each face that the ring encloses is counted
    as often as the ring winds around it: a loop driven twice counts twice, and areas on the two sides of the path do
    not cancel each other. Two loops around the same place in opposite directions do: the ring does not wind around it.
    """
    import shapely

    origin = path[0]
    trajectory, prescribed = trajectory - origin, path - origin
    if len(trajectory) > MOST_POINTS:
        trajectory = shapely.get_coordinates(
            shapely.simplify(shapely.LineString(trajectory), TOLERANCE, preserve_topology=False)
        )
    ring = np.vstack([trajectory, prescribed[::-1], trajectory[:1]])
    ring[np.abs(ring) < ZERO] = 0.0  # shapely's noding would divide by these coordinates
    ring = ring[np.r_[True, np.any(ring[1:] != ring[:-1], axis=1)]]
    if len(ring) < 3:
        return 0.0
    noded = shapely.unary_union([shapely.LineString(ring)], grid_size=GRID)
    faces = shapely.get_parts(shapely.polygonize(shapely.get_parts(noded)))
    if not len(faces):
        return 0.0
    inside = shapely.get_coordinates(shapely.point_on_surface(faces))
    return float(np.sum(np.abs(winding_numbers(ring, inside)) * shapely.area(faces)))


def winding_numbers(ring: Numbers, places: Numbers) -> NDArray[np.int64]:
    """Return how often the closed `ring` (n, 2) winds around each of `places` (k, 2), counter-clockwise positive.

    A ray goes from each place towards +x: an edge that crosses the ray upwards counts +1, downwards -1.
    """
    start, end = ring[:-1], ring[1:]
    low, high = np.minimum(start[:, 1], end[:, 1]), np.maximum(start[:, 1], end[:, 1])
    numbers = np.empty(len(places), dtype=np.int64)
    order = np.argsort(places[:, 1])
    for first in range(0, len(order), BLOCK):
        block = order[first : first + BLOCK]
        x, y = places[block, 0, np.newaxis], places[block, 1, np.newaxis]
        candidates = (low <= y[-1]) & (high >= y[0])  # only these edges can cross a ray of this block
        a, b = start[candidates], end[candidates]
        along = b - a
        left = along[:, 0] * (y - a[:, 1]) - along[:, 1] * (x - a[:, 0])
        upwards = (a[:, 1] <= y) & (b[:, 1] > y) & (left > 0)
        downwards = (a[:, 1] > y) & (b[:, 1] <= y) & (left < 0)
        numbers[block] = upwards.sum(axis=1) - downwards.sum(axis=1)
    return numbers


def _checked(t: ArrayLike, x: ArrayLike, y: ArrayLike) -> tuple[Numbers, Numbers]:
    times = np.asarray(t, dtype=np.float64)
    if times.ndim != 1 or len(times) == 0:
        raise ValueError(Text("measure-no-rows"))
    points = np.column_stack([_column("x", x, len(times)), _column("y", y, len(times))])
    if not np.all(np.isfinite(times)):
        raise ValueError(Text("measure-not-finite", column="t", row=int(np.argmin(np.isfinite(times))) + 1))
    backwards = np.flatnonzero(np.diff(times) < 0)
    if len(backwards):
        raise ValueError(Text("measure-time-backwards", row=int(backwards[0]) + 2))
    return times, points


def _column(name: str, values: ArrayLike, n: int) -> Numbers:
    column = np.asarray(values, dtype=np.float64)
    if column.shape != (n,):
        raise ValueError(Text("measure-lengths", column=name, rows=column.size, times=n))
    if not np.all(np.isfinite(column)):
        raise ValueError(Text("measure-not-finite", column=name, row=int(np.argmin(np.isfinite(column))) + 1))
    return column


def cut_at_goal(t: Numbers, points: Numbers, path: Path, goal_radius: float) -> Cut:
    """Return the trajectory up to where it first reaches the goal, or the whole trajectory when it never does.

    The goal is reached when the chair comes within `goal_radius` (m) of the path's end after most of the path was
    covered. The cut is at the place nearest to the path's end before the chair leaves the radius again, between two
    rows if necessary, so that trajectory and path end at the same place. A trial that was ended at the edge of the
    goal's circle ends there.
    """
    goal = np.array(path.points[-1])
    start, along = points[:-1], np.diff(points, axis=0)
    square = (along * along).sum(axis=1)
    share = np.clip(((goal - start) * along).sum(axis=1) / np.where(square > 0, square, 1.0), 0.0, 1.0)
    distance = np.hypot(*(start + share[:, np.newaxis] * along - goal).T)
    rounding = 1e-9
    inside = np.flatnonzero(distance <= goal_radius + rounding)
    inside = inside[inside >= _covered_from(points, path, goal_radius)] if len(inside) else inside
    if not len(inside):
        return Cut(t, points, len(t) - 1, False)
    apart = np.flatnonzero(np.diff(inside) > 1)
    first_stay = inside[: apart[0] + 1] if len(apart) else inside
    nearest = int(first_stay[np.argmin(distance[first_stay])])
    at = share[nearest]
    if at == 0.0:
        return Cut(t[: nearest + 1], points[: nearest + 1], nearest, True)
    end = start[nearest] + at * along[nearest]
    end_t = t[nearest] + at * (t[nearest + 1] - t[nearest])
    return Cut(
        np.append(t[: nearest + 1], end_t),
        np.vstack([points[: nearest + 1], end]),
        nearest + 1 if at == 1.0 else nearest,
        True,
    )


def _covered_from(points: Numbers, path: Path, goal_radius: float) -> int:
    """Return the first piece of the trajectory after which most of the path is covered; their number when none is."""
    progress = LineProgress(path, goal_radius)
    x, y = (float(value) for value in points[0])
    progress.update(x, y)
    for piece, (next_x, next_y) in enumerate(points[1:].tolist()):
        length = math.hypot(next_x - x, next_y - y)
        steps = max(1, math.ceil(length / SPACING))
        for step in range(1, steps + 1):
            progress.update(x + (next_x - x) * step / steps, y + (next_y - y) * step / steps)
        x, y = next_x, next_y
        if progress.covered_most:
            return piece
    return len(points) - 1


def sparc(speed: NDArray[np.float64], sample_rate: float) -> float | None:
    """Return the spectral arc length of a speed profile: at most 0, smoother nearer to 0, None without movement.

    Parameters
    ----------
    speed
        (n,) m/s, evenly sampled.
    sample_rate
        Hz.

    Notes
    -----
    Source: Balasubramanian, Melendez-Calderon, Roby-Brami, Burdet: On the analysis of movement smoothness,
    J NeuroEngineering and Rehabilitation 12:112, 2015.
    """
    if len(speed) < 2 or not np.any(speed):
        return None
    n = 2 ** (math.ceil(math.log2(len(speed))) + PAD_LEVEL)
    spectrum = np.abs(np.fft.rfft(speed, n))
    spectrum /= spectrum.max()
    frequency = np.arange(len(spectrum)) * (sample_rate / n)
    loud = np.flatnonzero((frequency <= HIGHEST_FREQUENCY) & (spectrum >= THRESHOLD))
    if len(loud) == 0 or loud[0] == loud[-1]:
        return None
    spectrum, frequency = spectrum[loud[0] : loud[-1] + 1], frequency[loud[0] : loud[-1] + 1]
    along = np.diff(frequency) / (frequency[-1] - frequency[0])
    return -float(np.sum(np.hypot(along, np.diff(spectrum))))


def log_dimensionless_jerk(speed: NDArray[np.float64], sample_rate: float) -> float | None:
    """Return -ln of a speed profile's dimensionless jerk: smoother nearer to 0, None at a constant speed.

    Parameters
    ----------
    speed
        (n,) m/s, evenly sampled.
    sample_rate
        Hz.

    Notes
    -----
    The squared jerk, integrated over the movement, times duration cubed over peak speed squared. Source as for `sparc`.
    """
    if len(speed) < 3:
        return None
    peak = float(np.max(np.abs(speed)))
    jerk = np.diff(speed, 2) * sample_rate**2
    duration = len(speed) / sample_rate
    if peak == 0.0:
        return None
    dimensionless = duration**3 / peak**2 * float(np.sum(jerk**2)) / sample_rate
    return -math.log(dimensionless) if dimensionless > LEAST_JERK else None
