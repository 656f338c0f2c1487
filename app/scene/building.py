"""The meshes of a floor plan: what is drawn of a building, without any drawing."""

import math
from itertools import pairwise
from typing import Final

import numpy as np

from app.scene import palette
from app.scene.furniture import furniture
from app.scene.meshes import Mesh, Part, box, merged, quads, rectangle, ring, standing_box, strip, tube
from app.scene.palette import Colour
from app.world.floorplan import Door, FloorPlan, PrescribedPath

MARGIN = 0.6  # m of floor outside the outer walls
TILE = 1.0  # m; tiles let one see how fast one moves
DOOR_HEIGHT = 2.05  # m
FRAME_WIDTH = 0.06  # m, of a door post
SKIRTING_HEIGHT = 0.09  # m
PATH_WIDTH = 0.16  # m
PATH_EDGE = 0.035  # m of a darker rim on each side, so that white shows on a light floor
SHORTEST_WALL_PIECE = 1e-6  # m

FURNITURE: Final = "furniture_"  # how the names of its parts begin
WALLS: Final = ("wall_sides", "wall_tops")

# Heights above the floor, apart enough not to flicker when seen from the top.
TILES_AT: Final = 0.006
EDGE_AT: Final = 0.014
PATH_AT: Final = 0.022
GOAL_AT: Final = 0.03


def building_parts(plan: FloorPlan) -> dict[str, Part]:
    """Return what stands still: walls, door frames, furniture, floor.

    They are drawn in this order. What hides much comes first, so that little is painted twice: a tablet's time goes
    into pixels, not into triangles.
    """
    x_min, y_min, x_max, y_max = plan.bounds
    floor = rectangle(x_min - MARGIN, y_min - MARGIN, x_max + MARGIN, y_max + MARGIN, 0.0)
    pieces = {f"{FURNITURE}{'_'.join(map(str, colour))}": Part(mesh, colour) for colour, mesh in _furniture(plan)}
    ground = {"tiles": Part(_tiles(plan), palette.FLOOR_TILE), "floor": Part(floor, palette.FLOOR)}
    return _wall_parts(plan) | _door_parts(plan) | pieces | ground


def _wall_parts(plan: FloorPlan) -> dict[str, Part]:
    """Return the walls, which some views cut low: sides, tops and skirting."""
    sides, tops, skirting = [], [], []
    thickness, height = plan.wall_thickness, plan.wall_height
    for wall in plan.walls:
        for (ax, ay), (bx, by) in pairwise(wall):
            length = math.hypot(bx - ax, by - ay)
            if length < SHORTEST_WALL_PIECE:
                continue
            place = ((ax + bx) / 2, (ay + by) / 2, 0.0, math.atan2(by - ay, bx - ax))
            whole = length + 0.98 * thickness  # fills the corners, and ends just inside a wall that it runs into
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
    """Return the door frames and the wall above them, which hide the way when seen from above."""
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


def path_parts(path: PrescribedPath) -> dict[str, Part]:
    """Return the white path on the floor, and its goal: a ring of the goal's size and a flag beside it."""
    points = path.line.points
    x, y = points[-1]
    heading = path.line.heading_at(path.line.length)
    flag = merged([tube((0.0, 0.0, 0.0), (0.0, 0.0, 1.5), 0.018), _cloth()])
    beside = path.goal_radius
    at = (x - math.sin(heading) * beside, y + math.cos(heading) * beside)
    return {
        "path": Part(strip(points, PATH_WIDTH, PATH_AT), palette.PATH),
        "path_edge": Part(strip(points, PATH_WIDTH + 2 * PATH_EDGE, EDGE_AT), palette.PATH_EDGE),
        "goal": Part(ring((x, y, GOAL_AT), 0.86 * path.goal_radius, path.goal_radius), palette.GOAL),
        "flag": Part(flag.moved(*at, heading=heading), palette.GOAL),
    }


def _furniture(plan: FloorPlan) -> list[tuple[Colour, Mesh]]:
    return sorted(furniture(plan.obstacles).items())


def _tiles(plan: FloorPlan) -> Mesh:
    """Return every second square of a chequered floor."""
    x_min, y_min, x_max, y_max = plan.bounds
    columns, rows = math.ceil((x_max - x_min) / TILE), math.ceil((y_max - y_min) / TILE)
    column, row = np.meshgrid(np.arange(columns), np.arange(rows), indexing="ij")
    chosen = (column + row) % 2 == 0
    x, y = x_min + TILE * column[chosen], y_min + TILE * row[chosen]
    x_end, y_end = np.minimum(x + TILE, x_max), np.minimum(y + TILE, y_max)
    z = np.full(len(x), TILES_AT)
    corners = [(x, y, z), (x_end, y, z), (x_end, y_end, z), (x, y_end, z)]
    return quads(np.stack([np.stack(corner, axis=-1) for corner in corners], axis=1))


def _without_ends(body: Mesh) -> Mesh:
    """Return a box without top and bottom: the top has a colour of its own."""
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


def _cloth() -> Mesh:
    """Return a three-cornered flag, seen from both sides."""
    corners = np.array([[0.0, 0.0, 1.48], [0.0, 0.34, 1.34], [0.0, 0.0, 1.2]])
    return Mesh(np.concatenate([corners, corners]), np.array([[0, 1, 2], [5, 4, 3]]))
