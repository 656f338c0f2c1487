"""What a trajectory met: cones, gaps and doors, and a leader."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.scoring.command_counts import contact_rows
from app.world.collision import Collision
from app.world.floorplan import Door, FloorPlan
from app.world.kinematics import CHAIR_RADIUS
from app.world.scenery import Gap, Track

Numbers = NDArray[np.float64]

DEEP = 0.6  # m before and behind a gap's middle in which its clearance is looked for
BESIDE = 0.9  # m around a gap's middle in which a contact is one with it: a crate of 0.5 m is touched from its front
NEAR = 0.5  # m beside the asked distance that still count as near it


def cones_touched(plan: FloorPlan, points: Numbers) -> int:
    """Return how many of the plan's cones the chair touched on its way through `points` (n, 2) in m."""
    touched = 0
    for cone in plan.cones:
        nearest = _distance_to(points, np.array(cone.position))
        touched += bool(nearest <= cone.radius + CHAIR_RADIUS)
    return touched


def gap_clearance(plan: FloorPlan, points: Numbers) -> float | None:
    """Return the smallest room (m) left beside the chair in any gap or door that it went through; None: through none.

    The room is that to walls and obstacles, whatever makes the gap narrow; 0 when it was touched.
    """
    collision = Collision(plan)
    rooms: list[float] = []
    for gap in _gaps(plan):
        along, across = _seen_from(gap, points)
        inside = np.abs(across) < gap.width / 2
        passed = np.any((along[:-1] < 0) != (along[1:] < 0) & inside[:-1] & inside[1:]) if len(along) > 1 else False
        if passed:
            near = points[(np.abs(along) <= DEEP) & inside].tolist()
            rooms += [collision.room(x, y) for x, y in near]
    return max(0.0, min(rooms)) if rooms else None


def contacts_at_gaps(plan: FloorPlan, points: Numbers, t: Numbers, touching: NDArray[np.bool_]) -> int:
    """Return how often the chair began to touch something at a gap or door."""
    began = points[contact_rows(touching, t)]
    near = np.zeros(len(began), dtype=np.bool_)
    for gap in _gaps(plan):
        near |= np.hypot(*(began - np.array(gap.position)).T) <= BESIDE
    return int(near.sum())


def following_errors(leader: Track, asked: float, rows: Mapping[str, NDArray[Any]]) -> dict[str, float]:
    """Return how well a leader was followed: errors of the distance between the two middles against `asked` (m)."""
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


def _seen_from(gap: Gap | Door, points: Numbers) -> tuple[Numbers, Numbers]:
    """Return how far (m) each point lies behind the gap's middle, and how far to its left."""
    away = points - np.array(gap.position)
    cos, sin = np.cos(gap.heading), np.sin(gap.heading)
    return away[:, 0] * cos + away[:, 1] * sin, away[:, 1] * cos - away[:, 0] * sin


def _distance_to(points: Numbers, place: Numbers) -> float:
    """Return how near (m) the line through `points` comes to a place."""
    if len(points) < 2:
        return float(np.hypot(*(points[0] - place)))
    start, along = points[:-1], np.diff(points, axis=0)
    square = (along * along).sum(axis=1)
    share = np.clip(((place - start) * along).sum(axis=1) / np.where(square > 0, square, 1.0), 0.0, 1.0)
    return float(np.hypot(*(start + share[:, np.newaxis] * along - place).T).min())
