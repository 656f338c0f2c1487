"""The meshes of what stands still in a floor plan: walls, doors, furniture, marks, ground."""

import math
from itertools import pairwise
from typing import Final

import numpy as np

from app.scene.meshes import palette
from app.scene.meshes.bodies import Mesh, Part, box, merged, rectangle, standing_box
from app.scene.meshes.furniture import ModelOf, furniture, no_model
from app.scene.meshes.ground import ground_parts
from app.scene.task_marks import gap_parts
from app.world.floorplan import Door, FloorPlan

DOOR_HEIGHT = 2.05  # m
FRAME_WIDTH = 0.06  # m, of a door post
SKIRTING_HEIGHT = 0.09  # m
SHORTEST_WALL_PIECE = 1e-6  # m

FURNITURE: Final = "furniture_"  # prefix of the names of its parts
WALLS: Final = ("wall_sides", "wall_tops")


def building_parts(plan: FloorPlan, model_of: ModelOf = no_model) -> dict[str, Part]:
    """Return the parts of walls, door frames, furniture, marks and ground, in the order in which they are drawn.

    Parts that hide much come first, so that few pixels are painted twice: on a tablet, pixels cost more time than
    triangles.
    """
    standing = sorted(furniture(plan.obstacles, model_of).items())
    pieces = {f"{FURNITURE}{'_'.join(map(str, colour))}": Part(mesh, colour) for colour, mesh in standing}
    return _wall_parts(plan) | _door_parts(plan) | pieces | gap_parts(plan.gaps) | ground_parts(plan)


def _wall_parts(plan: FloorPlan) -> dict[str, Part]:
    """Return the parts of the walls: sides, tops and skirting."""
    if not plan.walls:
        return {}
    sides, tops, skirting = [], [], []
    thickness, height = plan.wall_thickness, plan.wall_height
    for wall in plan.walls:
        for (ax, ay), (bx, by) in pairwise(wall):
            length = math.hypot(bx - ax, by - ay)
            if length < SHORTEST_WALL_PIECE:
                continue
            place = ((ax + bx) / 2, (ay + by) / 2, 0.0, math.atan2(by - ay, bx - ax))
            whole = length + 0.98 * thickness  # fills the corners, and ends just inside an adjoining wall
            body = standing_box(whole, thickness, 0.0, height)
            sides.append(_without_ends(body).moved(*place))
            tops.append(rectangle(-whole / 2, -thickness / 2, whole / 2, thickness / 2, height).moved(*place))
            base = standing_box(whole + 0.024, thickness + 0.024, 0.0, SKIRTING_HEIGHT)
            skirting.append(base.moved(*place))
    return {
        "wall_sides": Part(merged(sides), palette.WALL),
        "wall_tops": Part(merged(tops), palette.WALL_TOP),
        "skirting": Part(merged(skirting), palette.SKIRTING),
    }


def _door_parts(plan: FloorPlan) -> dict[str, Part]:
    """Return the parts of the door frames and of the wall above the doors."""
    if not plan.doors:
        return {}
    frames = merged(_frame(door, plan.wall_thickness) for door in plan.doors)
    top = max(plan.wall_height - DOOR_HEIGHT, 0.0)
    parts = {"door_frames": Part(frames, palette.DOOR)}
    if top > 0:
        lintels = merged(
            standing_box(plan.wall_thickness * 0.98, door.width, DOOR_HEIGHT, plan.wall_height).moved(
                *door.position, heading=door.heading
            )
            for door in plan.doors
        )
        parts["lintels"] = Part(lintels, palette.WALL)
    return parts


def _without_ends(body: Mesh) -> Mesh:
    """Return a box without its top, which has another colour, and without its bottom."""
    faces = body.faces[~np.isin(body.faces[:, 0] // 4, (0, 1))]
    return Mesh(body.vertices, faces)


def _frame(door: Door, thickness: float) -> Mesh:
    deep, half = thickness + 0.06, door.width / 2
    post = FRAME_WIDTH / 2
    return merged(
        [
            standing_box(deep, FRAME_WIDTH, 0.0, DOOR_HEIGHT, y=-half + post),
            standing_box(deep, FRAME_WIDTH, 0.0, DOOR_HEIGHT, y=half - post),
            box((deep, door.width, FRAME_WIDTH), (0.0, 0.0, DOOR_HEIGHT - post)),
        ]
    ).moved(*door.position, heading=door.heading)
