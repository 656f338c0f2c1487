"""All measures of a trial of any task: those of its path, of its scene and of the task itself."""

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.geometry import Pose
from app.scoring.interruptions import driven_rows, interruption_measures, interruptions
from app.scoring.measures import MeasureValues
from app.scoring.path_measures import path_measures
from app.world.collision import Collision
from app.world.floorplan import Door, FloorPlan, PrescribedPath
from app.world.footprint import CHAIR_RADIUS
from app.world.movers import Track
from app.world.progress import CourseProgress, TaskProgress, TurnProgress, progress_of
from app.world.scenery import Gap
from app.world.tasks import Course, FollowLeader, FollowPath

Numbers = NDArray[np.float64]
Columns = Mapping[str, Numbers]

GAP_DEPTH = 0.6  # m before and behind a gap's middle over which the clearance is measured
CONTACT_RADIUS = 0.9  # m around a gap's middle within which contacts are with the gap; includes a 0.5 m crate's front
LEADER_NEAR = 0.5  # m; a smaller error of the distance to the leader counts as near
NEEDED = ("t", "x", "y", "theta", "v", "scene_t", "in_contact", "contacts", "u1", "u2")


def task_measures(plan: FloorPlan, path: PrescribedPath, columns: Mapping[str, ArrayLike]) -> MeasureValues:
    """Return the measures of a trial, from the time that motion was first permitted until the task was done.

    Parameters
    ----------
    plan, path
        The floor plan, and the path with its task.
    columns
        (n,) each: t (s), x, y (m), theta (rad), v (m/s), scene_t (s),
        in_contact, contacts (number up to each row), u1, u2 (-1..1). With `state` and `fault` of each row, only the
        time in which motion was permitted counts, and the trial's interruptions are measures, too.

    Returns
    -------
    dict
        For every task but a turn, the measures of `app.scoring.path_measures`; `reached` as the task defines it.
        With cones: cones_touched, cones. With gaps: gaps (their number). With gaps or doors: gap_clearance (m; None
        when none was passed), door_contacts. Following: follow_error_rms, follow_error_max (m), follow_near (share of
        time). Turning: heading_error_deg (absolute), turn_drift (m), time, collisions, contact_time (s). A course:
        stages_done, stages and parts, a list of each stage's own measures with its title and kind.

    Raises
    ------
    ValueError
        When nothing was driven, lengths differ, a number is not finite, or time goes backwards.
    """
    rows = {name: np.asarray(columns[name], dtype=np.float64) for name in NEEDED}
    if "state" not in columns:
        return _measures(plan, path, {**rows, **_no_interruption(rows)})
    measures = _measures(plan, path, driven_rows({**rows, "state": np.asarray(columns["state"], dtype=np.float64)}))
    all_interruptions = interruptions(rows["t"], columns["state"], columns["fault"])
    return measures | interruption_measures(all_interruptions, measures["time"], reached=measures["reached"])


def _no_interruption(rows: Columns) -> dict[str, Numbers]:
    return {"permitted": np.ones(len(rows["t"])), "restart": np.zeros(len(rows["t"]))}


def _measures(plan: FloorPlan, path: PrescribedPath, rows: Columns) -> MeasureValues:
    rows = {**rows, "began": np.diff(rows["contacts"], prepend=0.0)}  # number of contacts that began in each row
    if isinstance(path.task, Course):
        return _course_measures(plan, path, rows)
    return _single_task_measures(plan, path, rows)


def _single_task_measures(plan: FloorPlan, path: PrescribedPath, rows: Columns) -> MeasureValues:
    progress = progress_of(plan, path)
    if isinstance(path.task, FollowPath):
        # The path's measures end where the chair is nearest to the goal, not where it comes within the goal's radius.
        return _path_measures(path, rows) | _scene_measures(plan, _rows_until_done(rows, progress))
    rows = _rows_until_done(rows, progress)
    if isinstance(progress, TurnProgress):
        measures: MeasureValues = {
            "time": _duration(rows),
            "heading_error_deg": math.degrees(abs(progress.heading_error)),
            "turn_drift": float(np.hypot(rows["x"] - path.points[0][0], rows["y"] - path.points[0][1]).max()),
            "collisions": int(rows["began"].sum()),
            "contact_time": _time_in_contact(rows),
        }
    else:
        measures = _path_measures(path, rows)
    if isinstance(path.task, FollowLeader):
        measures |= following_errors(Track(plan.mover_named(path.task.leader)), path.task.distance, rows)
    return measures | _scene_measures(plan, rows) | {"reached": progress.reached}


def _course_measures(plan: FloorPlan, path: PrescribedPath, rows: Columns) -> MeasureValues:
    progress = progress_of(plan, path)
    assert isinstance(progress, CourseProgress)
    stage = np.empty(len(rows["t"]), dtype=np.intp)
    last = len(stage)
    for row, (pose, v, scene_t) in enumerate(_states(rows)):
        stage[row] = progress.stage
        progress.update(pose, v, scene_t)
        if progress.reached:
            last = row + 1
            break
    rows = {name: column[:last] for name, column in rows.items()}
    stage = stage[:last]
    parts = []
    for number, part in enumerate(progress.parts):
        stage_rows = {name: column[stage == number] for name, column in rows.items()}
        measures: MeasureValues = {"title": part.title, "kind": part.task.kind, "reached": False}
        if len(stage_rows["t"]) > 1:
            measures |= _single_task_measures(plan, part, stage_rows)
        measures["reached"] = number < progress.stage or progress.reached
        parts.append(measures)
    return {
        "time": _duration(rows),
        "dist": float(np.hypot(np.diff(rows["x"]), np.diff(rows["y"])).sum()),
        "collisions": int(rows["began"].sum()),
        "contact_time": _time_in_contact(rows),
        **_scene_measures(plan, rows),
        "stages_done": sum(part["reached"] for part in parts),
        "stages": len(parts),
        "parts": parts,
        "reached": progress.reached,
    }


def _path_measures(path: PrescribedPath, rows: Columns) -> MeasureValues:
    names = ("in_contact", "u1", "u2", "permitted", "restart")
    extras = {"contacts": np.cumsum(rows["began"])} | {name: rows[name] for name in names}
    return dict(path_measures(rows["t"], rows["x"], rows["y"], path.points, path.goal_radius, **extras))


def _scene_measures(plan: FloorPlan, rows: Columns) -> MeasureValues:
    """Return the measures of cones, gaps and doors, for those that the plan has."""
    points = np.column_stack([rows["x"], rows["y"]])
    measures: MeasureValues = {}
    if plan.cones:
        measures |= {"cones_touched": cones_touched(plan, points), "cones": len(plan.cones)}
    if plan.gaps:
        measures["gaps"] = len(plan.gaps)
    if plan.gaps or plan.doors:
        measures["gap_clearance"] = gap_clearance(plan, points)
        measures["door_contacts"] = contacts_at_gaps(plan, points[rows["began"] > 0])
    return measures


def _rows_until_done(rows: Columns, progress: TaskProgress) -> Columns:
    """Return the rows up to and with the one in which the task was done."""
    for row, (pose, v, scene_t) in enumerate(_states(rows)):
        progress.update(pose, v, scene_t)
        if progress.reached:
            return {name: column[: row + 1] for name, column in rows.items()}
    return rows


def _states(rows: Columns) -> list[tuple[Pose, float, float]]:
    columns = (rows[name].tolist() for name in ("x", "y", "theta", "v", "scene_t"))
    return [(Pose(x, y, theta), v, scene_t) for x, y, theta, v, scene_t in zip(*columns, strict=True)]


def _duration(rows: Columns) -> float:
    return float(np.diff(rows["t"])[rows["permitted"][1:] != 0].sum())


def _time_in_contact(rows: Columns) -> float:
    return float(np.diff(rows["t"])[rows["in_contact"][1:] != 0].sum())


def cones_touched(plan: FloorPlan, points: Numbers) -> int:
    """Return how many of the plan's cones the chair touched along `points` (n, 2) in m."""
    touched = 0
    for cone in plan.cones:
        nearest = _distance_to(points, np.array(cone.position))
        touched += bool(nearest <= cone.radius + CHAIR_RADIUS)
    return touched


def gap_clearance(plan: FloorPlan, points: Numbers) -> float | None:
    """Return the smallest clearance (m) beside the chair in the gaps and doors that it went through.

    The clearance is that to walls and obstacles; 0 when one was touched, None when the chair went through no gap.
    """
    collision = Collision(plan)
    clearances: list[float] = []
    for gap in _gaps(plan):
        along, across = _in_gap_frame(gap, points)
        inside = np.abs(across) < gap.width / 2
        passed = np.any((along[:-1] < 0) != (along[1:] < 0) & inside[:-1] & inside[1:]) if len(along) > 1 else False
        if passed:
            near = points[(np.abs(along) <= GAP_DEPTH) & inside].tolist()
            clearances += [collision.room(x, y) for x, y in near]
    return max(0.0, min(clearances)) if clearances else None


def contacts_at_gaps(plan: FloorPlan, began: Numbers) -> int:
    """Return how many contacts began within 0.9 m of a gap or door; `began` (n, 2) in m, where each one began."""
    near = np.zeros(len(began), dtype=np.bool_)
    for gap in _gaps(plan):
        near |= np.hypot(*(began - np.array(gap.position)).T) <= CONTACT_RADIUS
    return int(near.sum())


def following_errors(leader: Track, distance: float, rows: Columns) -> dict[str, float]:
    """Return the errors of the distance between the middles of chair and leader against `distance` (m)."""
    places = np.array([leader.at(float(scene_t)).pose[:2] for scene_t in rows["scene_t"]])
    error = np.hypot(rows["x"] - places[:, 0], rows["y"] - places[:, 1]) - distance
    weight = np.diff(rows["t"], append=rows["t"][-1])
    if not weight.sum() > 0.0:
        weight = np.ones(len(error))
    return {
        "follow_error_rms": float(np.sqrt(np.average(error**2, weights=weight))),
        "follow_error_max": float(np.abs(error).max()),
        "follow_near": float(np.average(np.abs(error) <= LEADER_NEAR, weights=weight)),
    }


def _gaps(plan: FloorPlan) -> list[Gap | Door]:
    return [*plan.gaps, *plan.doors]


def _in_gap_frame(gap: Gap | Door, points: Numbers) -> tuple[Numbers, Numbers]:
    """Return how far (m) each point lies along the gap's heading from its middle, and how far to the left."""
    away = points - np.array(gap.position)
    cos, sin = np.cos(gap.heading), np.sin(gap.heading)
    return away[:, 0] * cos + away[:, 1] * sin, away[:, 1] * cos - away[:, 0] * sin


def _distance_to(points: Numbers, place: Numbers) -> float:
    """Return the smallest distance (m) from the line through `points` to a place."""
    if len(points) < 2:
        return float(np.hypot(*(points[0] - place)))
    start, along = points[:-1], np.diff(points, axis=0)
    square = (along * along).sum(axis=1)
    share = np.clip(((place - start) * along).sum(axis=1) / np.where(square > 0, square, 1.0), 0.0, 1.0)
    return float(np.hypot(*(start + share[:, np.newaxis] * along - place).T).min())
