"""The marks of a task on the floor: the path, the goal, the spot to turn on, the box to back into, the gaps' sides."""

import math
from typing import Final

import numpy as np

from app.scene.meshes import palette
from app.scene.meshes.bodies import Mesh, Part, ball, merged, quads, ring, strip, tube
from app.world.floorplan import PrescribedPath
from app.world.scenery import Gap
from app.world.tasks import Back, Course, Turn

PATH_WIDTH = 0.16  # m
PATH_EDGE = 0.035  # m of a darker rim on each side, so that white shows on a light floor
LATER_WIDTH: Final = 0.07  # m, of later stages

SPOT: Final = 0.75  # m, radius of the circle to turn on
TURN_ARROW: Final = (1.75, 1.91)  # m, radii: far enough out to be seen from the chair
TURN_STEP: Final = 0.06  # rad
HEAD: Final = (0.3, 0.34)  # m, length and width of an arrow's head
POLE: Final = 1.5  # m

BOX: Final = (1.3, 0.9)  # m, length and width of the box to back into
HATCH: Final = 0.22  # m between its lines
LINE: Final = 0.05  # m

GAP_MARK: Final = (1.2, 0.06)  # m, length and width

# Heights (m) above the floor, far enough apart not to flicker in the view from the top.
LATER_AT: Final = 0.011
EDGE_AT: Final = 0.014
PATH_AT: Final = 0.022
GOAL_AT: Final = 0.03


def task_parts(path: PrescribedPath) -> dict[str, Part]:
    """Return the marks of a task, or of a stage of a course."""
    match path.task:
        case Turn():
            return _turn_parts(path, path.task)
        case Back():
            return _path_parts(path) | {"goal": Part(_hatched_box(path), palette.GOAL), "flag": _flag(path)}
        case _:
            x, y = path.points[-1]
            goal = ring((x, y, GOAL_AT), 0.86 * path.goal_radius, path.goal_radius)
            return _path_parts(path) | {"goal": Part(goal, palette.GOAL), "flag": _flag(path)}


def later_parts(path: PrescribedPath) -> dict[str, Part]:
    """Return all stages of a course as thin lines under the present stage; nothing for other tasks."""
    if not isinstance(path.task, Course):
        return {}
    lines = [stage.points for stage in path.task.stages if not isinstance(stage.task, Turn)]
    return {"later": Part(merged(strip(line, LATER_WIDTH, LATER_AT) for line in lines), palette.LATER)} if lines else {}


def gap_parts(gaps: tuple[Gap, ...]) -> dict[str, Part]:
    """Return two lines on the floor for each gap, along the sides of its free width."""
    if not gaps:
        return {}
    length, width = GAP_MARK
    marks = []
    for gap in gaps:
        for side in (-1, 1):
            y = side * (gap.width - width) / 2
            mark = strip([(-length / 2, y), (length / 2, y)], width, EDGE_AT)
            marks.append(mark.moved(*gap.position, heading=gap.heading))
    return {"gap_marks": Part(merged(marks), palette.MARK)}


def _path_parts(path: PrescribedPath) -> dict[str, Part]:
    return {
        "path": Part(strip(path.points, PATH_WIDTH, PATH_AT), palette.PATH),
        "path_edge": Part(strip(path.points, PATH_WIDTH + 2 * PATH_EDGE, EDGE_AT), palette.PATH_EDGE),
    }


def _flag(path: PrescribedPath) -> Part:
    """Return a flag beside the goal."""
    x, y = path.points[-1]
    heading = path.line.heading_at(path.line.length)
    beside = path.goal_radius
    flag = merged([tube((0.0, 0.0, 0.0), (0.0, 0.0, POLE), 0.018), _cloth()])
    return Part(
        flag.moved(x - math.sin(heading) * beside, y + math.cos(heading) * beside, heading=heading), palette.GOAL
    )


def _cloth() -> Mesh:
    """Return a triangular flag that is visible from both sides."""
    corners = np.array([[0.0, 0.0, 1.48], [0.0, 0.34, 1.34], [0.0, 0.0, 1.2]])
    return Mesh(np.concatenate([corners, corners]), np.array([[0, 1, 2], [5, 4, 3]]))


def _turn_parts(path: PrescribedPath, task: Turn) -> dict[str, Part]:
    """Return the spot to turn on, an arrow around it from the first heading to the last, and the mark to turn to."""
    x, y = path.points[0]
    target, start = path.line.heading_at(0.0), path.start.theta
    sign = 1.0 if task.direction == "left" else -1.0
    sweep = (sign * (target - start)) % math.tau or math.tau
    inner, outer = TURN_ARROW
    middle = (inner + outer) / 2
    reach = max(sweep - HEAD[0] / middle, TURN_STEP)  # rad; at this angle the arrow's head begins
    turns = start + sign * np.linspace(0.0, reach, max(2, math.ceil(reach / TURN_STEP)))
    round_it = [(middle * math.cos(turn), middle * math.sin(turn)) for turn in turns]
    arc = strip(round_it, outer - inner, PATH_AT)
    rim = strip(round_it, outer - inner + 2 * PATH_EDGE, EDGE_AT)
    end = float(turns[-1])
    head = _arrow_head().moved(middle * math.cos(end), middle * math.sin(end), heading=end + sign * math.pi / 2)
    far = math.dist(path.points[0], path.points[-1])
    pole = merged([tube((0.0, 0.0, 0.0), (0.0, 0.0, POLE), 0.03), ball((0.0, 0.0, POLE), 0.14)])
    return {
        "goal": Part(ring((x, y, GOAL_AT), 0.9 * SPOT, SPOT), palette.GOAL),
        "path": Part(merged([arc, head]).moved(x, y), palette.PATH),
        "path_edge": Part(rim.moved(x, y), palette.PATH_EDGE),
        "mark": Part(pole.moved(far, 0.0).moved(x, y, heading=target), palette.GOAL),
    }


def _arrow_head() -> Mesh:
    """Return the head of an arrow that points along x from the origin."""
    length, width = HEAD
    return Mesh(
        np.array([[0.0, -width / 2, PATH_AT], [length, 0.0, PATH_AT], [0.0, width / 2, PATH_AT]]),
        np.array([[0, 1, 2]]),
    )


def _hatched_box(path: PrescribedPath) -> Mesh:
    """Return a hatched box around the path's end, parallel to the path's last piece."""
    half_x, half_y = BOX[0] / 2, BOX[1] / 2
    corners = [(-half_x, -half_y), (half_x, -half_y), (half_x, half_y), (-half_x, half_y)]
    lines = [strip(pair, LINE, GOAL_AT) for pair in zip(corners, [*corners[1:], corners[0]], strict=True)]
    for shift in np.arange(-half_x - half_y + HATCH, half_x + half_y, HATCH):
        # The part of the line x + y = shift that is inside the box.
        low, high = max(-half_x, shift - half_y), min(half_x, shift + half_y)
        if high - low > LINE:
            lines.append(strip([(low, shift - low), (high, shift - high)], LINE / 2, GOAL_AT))
    joints = [quads(_square(*corner)[np.newaxis]) for corner in corners]
    heading = path.line.heading_at(path.line.length)
    return merged([*lines, *joints]).moved(*path.points[-1], heading=heading)


def _square(x: float, y: float) -> np.ndarray:
    half = LINE / 2
    return np.array([[x + a * half, y + b * half, GOAL_AT] for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
