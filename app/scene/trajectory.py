"""The driven trajectory as a red line on the floor, drawn in pieces of which only the last one is sent again."""

import math
from typing import Final, NamedTuple

import numpy as np
import viser
from numpy.typing import NDArray

from app.geometry import Pose, wrap_angle
from app.scene.meshes import palette

STEP = 0.05  # m; a point is kept when the chair has moved this far since the last point,
TURN = math.radians(5)  # or turned this far
JUMP = 0.5  # m; between two poses, the chair was put at another place when it moved farther than this
FASTEST = 3.0  # m/s; and also faster than this
PIECE = 200  # points; a piece with this many is complete and not sent again
SEND_EVERY = 0.2  # s
AT: Final = 0.045  # m above the floor, over the white path
THICKNESS = 4.0  # pixels


class Place(NamedTuple):
    """A place of the chair, with its time."""

    x: float  # m
    y: float
    t: float  # s


def is_jump(before: Place, after: Place) -> bool:
    """Return whether the chair was put from one place to the other, too far and too fast for driving."""
    distance = math.hypot(after.x - before.x, after.y - before.y)
    return distance > max(JUMP, FASTEST * (after.t - before.t))


class PointFilter:
    """Selects the points of a trajectory that differ enough from the point before to be drawn."""

    def __init__(self) -> None:
        self._last: Pose | None = None

    def keep(self, pose: Pose) -> bool:
        """Return whether to keep this point: the first one, and each far enough from the last one kept."""
        last = self._last
        if (
            last is not None
            and math.hypot(pose.x - last.x, pose.y - last.y) < STEP
            and abs(wrap_angle(pose.theta - last.theta)) < TURN
        ):
            return False
        self._last = pose
        return True


class TrajectoryPieces:
    """The points of a trajectory in pieces; each begins at the end of the piece before, except after a jump."""

    def __init__(self) -> None:
        self._filter = PointFilter()
        self._last: Place | None = None
        self.points: list[list[tuple[float, float]]] = [[]]

    def add(self, pose: Pose, t: float) -> bool:
        """Add the pose at `t` (s); return whether it became a point of the last piece."""
        place = Place(pose.x, pose.y, t)
        begins = self._last is not None and is_jump(self._last, place)
        self._last = place
        if not self._filter.keep(pose):
            return False
        point = (pose.x, pose.y)
        piece = self.points[-1]
        if begins:
            self.points.append([])
        elif len(piece) >= PIECE:
            self.points.append([piece[-1]])
        self.points[-1].append(point)
        return True


class TrajectoryLine:
    """The trajectory on one role's 3D server."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server
        self._pieces = TrajectoryPieces()
        self._nodes: dict[int, viser.LineSegmentsHandle] = {}
        self._drawn = (0, 0)  # numbers of pieces, and of points in the last piece, that are drawn
        self._sent_at = -math.inf

    def add(self, pose: Pose, t: float) -> None:
        """Add the chair's pose at `t` (s), and draw new points at most five times a second."""
        self._pieces.add(pose, t)
        now = (len(self._pieces.points), len(self._pieces.points[-1]))
        if now == self._drawn or t - self._sent_at < SEND_EVERY:
            return
        # Pieces completed since the last drawing are drawn once more, up to their ends.
        for number in range(max(self._drawn[0] - 1, 0), now[0]):
            self._draw(number)
        self._drawn, self._sent_at = now, t

    def clear(self) -> None:
        """Remove the trajectory: a new trial begins."""
        for node in self._nodes.values():
            node.remove()
        self._nodes.clear()
        self._pieces = TrajectoryPieces()
        self._drawn, self._sent_at = (0, 0), -math.inf

    def _draw(self, number: int) -> None:
        segments = line_segments(self._pieces.points[number])
        if not len(segments):
            return
        if number in self._nodes:
            self._nodes[number].points = segments
            return
        self._nodes[number] = self._server.scene.add_line_segments(
            f"/world/driven/{number}", segments, palette.DRIVEN, thickness=THICKNESS, thickness_units="screen"
        )


def line_segments(points: list[tuple[float, float]]) -> NDArray[np.float32]:
    """Return the segments of a line through `points` (x, y): (n - 1, 2, 3) in m, just above the floor."""
    line = np.full((len(points), 3), AT, dtype=np.float32)
    line[:, :2] = np.array(points, dtype=np.float32).reshape(-1, 2)
    return np.stack([line[:-1], line[1:]], axis=1)
