"""All measures of a trial of any task: the path's, where it has one, and those of what it met on the way."""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.geometry import Pose
from app.scoring.command_counts import contact_beginnings
from app.scoring.path_measures import path_measures
from app.scoring.scene_measures import cones_touched, contacts_at_gaps, following_errors, gap_clearance
from app.world.floorplan import FloorPlan, PrescribedPath
from app.world.scenery import Track
from app.world.task_progress import CourseProgress, TaskProgress, TurnProgress, progress_of
from app.world.tasks import Course, FollowLeader, FollowPath

Columns = Mapping[str, NDArray[Any]]
Measures = dict[str, Any]

NEEDED = ("t", "x", "y", "theta", "v", "scene_t", "in_contact", "contacts", "u1", "u2")


def task_measures(plan: FloorPlan, path: PrescribedPath, columns: Mapping[str, ArrayLike]) -> Measures:
    """Return the measures of a trial from when motion was first permitted to when its task was done.

    Parameters
    ----------
    plan, path
        Where it was driven, and what was asked.
    columns
        (n,) each: t (s), x, y (m), theta (rad), v (m/s), scene_t (s; NaN in recordings from before there were
        scenes), in_contact, contacts (counted so far), u1, u2 (-1..1).

    Returns
    -------
    dict
        The measures of `app.scoring.path_measures`, but for a turn; `reached` by the task's own judgement. With cones:
        cones_touched, cones. With gaps: gaps (how many there are). With gaps or doors: gap_clearance (m; None when
        none was passed), door_contacts. Following: follow_error_rms, follow_error_max (m), follow_near (share of
        time). Turning: heading_error_deg (beside the mark, either way), turn_drift (m), time, collisions,
        contact_time (s). A course: stages_done, stages and parts, a list of each stage's own measures with its title
        and kind.

    Raises
    ------
    ValueError
        When nothing was driven, lengths differ, a number is not finite, or time goes backwards.
    """
    rows = {name: np.asarray(columns[name], dtype=np.float64) for name in NEEDED}
    rows["scene_t"] = np.where(np.isfinite(rows["scene_t"]), rows["scene_t"], rows["t"] - rows["t"][:1])
    if isinstance(path.task, Course):
        return _course(plan, path, rows)
    return _simple(plan, path, rows)


def _simple(plan: FloorPlan, path: PrescribedPath, rows: Columns) -> Measures:
    progress = progress_of(plan, path)
    if isinstance(path.task, FollowPath):
        # Its measures find their own end: where the chair comes nearest to the goal, not where it comes within reach.
        return _along(path, rows) | _met(plan, _until(rows, progress))
    rows = _until(rows, progress)
    if isinstance(progress, TurnProgress):
        measures: Measures = {
            "time": _duration(rows),
            "heading_error_deg": math.degrees(abs(progress.heading_error)),
            "turn_drift": float(np.hypot(rows["x"] - path.points[0][0], rows["y"] - path.points[0][1]).max()),
            "collisions": contact_beginnings(rows["in_contact"] != 0, rows["t"]),
            "contact_time": _time_in_contact(rows),
        }
    else:
        measures = _along(path, rows)
    if isinstance(path.task, FollowLeader):
        measures |= following_errors(Track(plan.mover_named(path.task.leader)), path.task.distance, rows)
    return measures | _met(plan, rows) | {"reached": progress.reached}


def _course(plan: FloorPlan, path: PrescribedPath, rows: Columns) -> Measures:
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
        words: Measures = {"title": part.title, "kind": part.task.kind, "reached": False}
        if len(own["t"]) > 1:
            words |= _simple(plan, part, own)
        words["reached"] = number < progress.stage or progress.reached
        parts.append(words)
    return {
        "time": _duration(rows),
        "dist": float(np.hypot(np.diff(rows["x"]), np.diff(rows["y"])).sum()),
        "collisions": contact_beginnings(rows["in_contact"] != 0, rows["t"]),
        "contact_time": _time_in_contact(rows),
        **_met(plan, rows),
        "stages_done": sum(part["reached"] for part in parts),
        "stages": len(parts),
        "parts": parts,
        "reached": progress.reached,
    }


def _along(path: PrescribedPath, rows: Columns) -> Measures:
    names = ("in_contact", "contacts", "u1", "u2")
    extras = {name: rows[name] for name in names}
    return dict(path_measures(rows["t"], rows["x"], rows["y"], path.points, path.goal_radius, **extras))


def _met(plan: FloorPlan, rows: Columns) -> Measures:
    """Return what a trial met on its way: cones, gaps and doors, as far as the plan has any."""
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


def _until(rows: Columns, progress: TaskProgress) -> Columns:
    """Return the rows up to the one with which the task was done."""
    for row, (pose, v, scene_t) in enumerate(_states(rows)):
        progress.update(pose, v, scene_t)
        if progress.reached:
            return {name: column[: row + 1] for name, column in rows.items()}
    return rows


def _states(rows: Columns) -> list[tuple[Pose, float, float]]:
    columns = (rows[name].tolist() for name in ("x", "y", "theta", "v", "scene_t"))
    return [(Pose(x, y, theta), v, scene_t) for x, y, theta, v, scene_t in zip(*columns, strict=True)]


def _duration(rows: Columns) -> float:
    return float(rows["t"][-1] - rows["t"][0])


def _time_in_contact(rows: Columns) -> float:
    return float(np.diff(rows["t"])[rows["in_contact"][1:] != 0].sum())
