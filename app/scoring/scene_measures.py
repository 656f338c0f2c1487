"""Measures of a trajectory in its scene: cones touched, clearance in gaps and doors, distance to a leader."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.scoring.command_counts import contact_rows
from app.world.collision import Collision
from app.world.floorplan import Door, FloorPlan
from app.world.kinematics import CHAIR_RADIUS
from app.world.movers import Track
from app.world.scenery import Gap

Numbers = NDArray[np.float64]

GAP_DEPTH = 0.6  # m before and behind a gap's middle over which the clearance is measured
CONTACT_RADIUS = 0.9  # m around a gap's middle within which contacts are with the gap; includes a 0.5 m crate's front
NEAR = 0.5  # m; a smaller error of the distance to the leader counts as near


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


def contacts_at_gaps(plan: FloorPlan, points: Numbers, t: Numbers, touching: NDArray[np.bool_]) -> int:
    """Return how many contacts began within 0.9 m of a gap or door; `touching` (n,) at the times `t` (n,) in s."""
    began = points[contact_rows(touching, t)]
    near = np.zeros(len(began), dtype=np.bool_)
    for gap in _gaps(plan):
        near |= np.hypot(*(began - np.array(gap.position)).T) <= CONTACT_RADIUS
    return int(near.sum())


def following_errors(leader: Track, asked: float, rows: Mapping[str, NDArray[Any]]) -> dict[str, float]:
    """Return the errors of the distance between the middles of chair and leader against the `asked` one (m)."""
    places = np.array([leader.at(float(scene_t)).pose[:2] for scene_t in rows["scene_t"]])
    error = np.hypot(rows["x"] - places[:, 0], rows["y"] - places[:, 1]) - asked
    weight = np.diff(rows["t"], append=rows["t"][-1])
    if not weight.sum() > 0.0:
        weight = np.ones(len(error))
    return {
        "follow_error_rms": float(np.sqrt(np.average(error**2, weights=weight))),
        "follow_error_max": float(np.abs(error).max()),
        "follow_near": float(np.average(np.abs(error) <= NEAR, weights=weight)),
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
