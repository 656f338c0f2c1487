"""All measures of a trial of any task: those of its path, of its scene and of the task itself."""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.geometry import Pose
from app.scoring.command_counts import contact_beginnings
from app.scoring.interruptions import driven_rows, interruption_measures, interruptions
from app.scoring.path_measures import path_measures
from app.scoring.scene_measures import cones_touched, contacts_at_gaps, following_errors, gap_clearance
from app.world.floorplan import FloorPlan, PrescribedPath
from app.world.movers import Track
from app.world.progress import CourseProgress, TaskProgress, TurnProgress, progress_of
from app.world.tasks import Course, FollowLeader, FollowPath

Columns = Mapping[str, NDArray[Any]]
Measures = dict[str, Any]

NEEDED = ("t", "x", "y", "theta", "v", "scene_t", "in_contact", "contacts", "u1", "u2")


def task_measures(plan: FloorPlan, path: PrescribedPath, columns: Mapping[str, ArrayLike]) -> Measures:
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
    measures = _measures(plan, path, driven_rows({**rows, "state": np.asarray(columns["state"])}))
    found = interruptions(rows["t"], columns["state"], columns["fault"])
    return measures | interruption_measures(found, measures["time"], reached=measures["reached"])


def _no_interruption(rows: Columns) -> dict[str, NDArray[Any]]:
    return {"permitted": np.ones(len(rows["t"])), "restart": np.zeros(len(rows["t"]))}


def _measures(plan: FloorPlan, path: PrescribedPath, rows: Columns) -> Measures:
    if isinstance(path.task, Course):
        return _course_measures(plan, path, rows)
    return _single_task_measures(plan, path, rows)


def _single_task_measures(plan: FloorPlan, path: PrescribedPath, rows: Columns) -> Measures:
    progress = progress_of(plan, path)
    if isinstance(path.task, FollowPath):
        # The path's measures end where the chair is nearest to the goal, not where it comes within the goal's radius.
        return _path_measures(path, rows) | _scene_measures(plan, _rows_until_done(rows, progress))
    rows = _rows_until_done(rows, progress)
    if isinstance(progress, TurnProgress):
        measures: Measures = {
            "time": _duration(rows),
            "heading_error_deg": math.degrees(abs(progress.heading_error)),
            "turn_drift": float(np.hypot(rows["x"] - path.points[0][0], rows["y"] - path.points[0][1]).max()),
            "collisions": contact_beginnings(rows["in_contact"] != 0, rows["t"]),
            "contact_time": _time_in_contact(rows),
        }
    else:
        measures = _path_measures(path, rows)
    if isinstance(path.task, FollowLeader):
        measures |= following_errors(Track(plan.mover_named(path.task.leader)), path.task.distance, rows)
    return measures | _scene_measures(plan, rows) | {"reached": progress.reached}


def _course_measures(plan: FloorPlan, path: PrescribedPath, rows: Columns) -> Measures:
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
        own = {name: column[stage == number] for name, column in rows.items()}
        measures: Measures = {"title": part.title, "kind": part.task.kind, "reached": False}
        if len(own["t"]) > 1:
            measures |= _single_task_measures(plan, part, own)
        measures["reached"] = number < progress.stage or progress.reached
        parts.append(measures)
    return {
        "time": _duration(rows),
        "dist": float(np.hypot(np.diff(rows["x"]), np.diff(rows["y"])).sum()),
        "collisions": contact_beginnings(rows["in_contact"] != 0, rows["t"]),
        "contact_time": _time_in_contact(rows),
        **_scene_measures(plan, rows),
        "stages_done": sum(part["reached"] for part in parts),
        "stages": len(parts),
        "parts": parts,
        "reached": progress.reached,
    }


def _path_measures(path: PrescribedPath, rows: Columns) -> Measures:
    names = ("in_contact", "contacts", "u1", "u2", "permitted", "restart")
    extras = {name: rows[name] for name in names}
    return dict(path_measures(rows["t"], rows["x"], rows["y"], path.points, path.goal_radius, **extras))


def _scene_measures(plan: FloorPlan, rows: Columns) -> Measures:
    """Return the measures of cones, gaps and doors, for those that the plan has."""
    points = np.column_stack([rows["x"], rows["y"]])
    measures: Measures = {}
    if plan.cones:
        measures |= {"cones_touched": cones_touched(plan, points), "cones": len(plan.cones)}
    if plan.gaps:
        measures["gaps"] = len(plan.gaps)
    if plan.gaps or plan.doors:
        measures["gap_clearance"] = gap_clearance(plan, points)
        measures["door_contacts"] = contacts_at_gaps(plan, points, rows["t"], rows["in_contact"] != 0)
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
