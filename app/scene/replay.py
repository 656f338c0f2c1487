"""The replay of a recorded trial in 3D, on a 3D server of its own: live pictures are not affected."""

import math
import threading
from pathlib import Path
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.geometry import Pose
from app.scene.cameras import View
from app.scene.drawing import drawing_of
from app.scene.head_view import NO_HEAD, Angles
from app.scene.role_servers import quiet_server
from app.scene.scene_state import SceneState
from app.scene.trajectory import TrajectoryLine
from app.scene.world_view import WorldView
from app.world.floorplan import FloorPlan

MOMENT_NODE: Final = "/moment"  # its x is the shown time (s), which the page reads
STILL: Final = 0.5  # s, time step of the head when the shown time does not change: the head moves at once to its angles

Numbers = NDArray[np.float64]


class ReplayPoses(NamedTuple):
    """The recorded poses of chair and head, with the scene's time; (n,) each, t rising."""

    t: Numbers  # s
    x: Numbers  # m
    y: Numbers  # m
    theta: Numbers  # rad
    v: Numbers  # m/s
    scene_t: Numbers  # s
    head: Numbers  # (n, 3) yaw, pitch, roll, rad; NaN where unknown


class Replay:
    """One recorded trial, shown at any time of it. Every method may be called from any thread.

    Raises
    ------
    OSError
        When this machine has no port left for its server.
    """

    def __init__(self, plan: FloorPlan, path_name: str, poses: ReplayPoses, models: Path | None = None) -> None:
        path = plan.path_named(path_name)
        self._poses = poses
        self._theta = np.unwrap(poses.theta)
        self._lock = threading.Lock()
        self._state = SceneState(plan, path)
        self._state_row = -1  # the last row with which the state was updated
        self._t = float(poses.t[0])
        self._server = quiet_server()
        try:
            self._view = WorldView(self._server)
            self._view.draw(drawing_of(plan, path, models))
            self._moment = self._server.scene.add_frame(MOMENT_NODE, show_axes=False, visible=False)
            trajectory = TrajectoryLine(self._server)
            for t, x, y, theta in zip(poses.t, poses.x, poses.y, poses.theta, strict=True):
                trajectory.add(Pose(float(x), float(y), float(theta)), float(t))
            self.show(self._t, "chase")
        except BaseException:
            self.stop()
            raise

    @property
    def port(self) -> int:
        """Return the port (on 127.0.0.1) that the server listens on."""
        return self._server.get_port()

    def show(self, t: float, view: View) -> None:
        """Show the time `t` (s), clipped to the recording, seen from `view`."""
        with self._lock:
            poses = self._poses
            t = min(max(t, float(poses.t[0])), float(poses.t[-1]))
            row = int(np.searchsorted(poses.t, t, side="right")) - 1
            self._update_state(row)
            if view != self._view.view:
                self._view.set_view(view)
            self._view.fit_picture()
            passed = abs(t - self._t)
            self._t = t
            self._view.follow(self._pose_at(t), passed or STILL, *self._head_at(row), self._state)
            self._moment.position = (t, 0.0, 0.0)
            self._server.flush()

    def stop(self) -> None:
        """End the server and its threads."""
        self._server.stop()

    def _update_state(self, row: int) -> None:
        """Bring task, cones and movers to the state after `row`; begin again when `row` is an earlier one."""
        if row < self._state_row:
            self._state.begin_again()
            self._state_row = -1
        poses = self._poses
        for i in range(self._state_row + 1, row + 1):
            pose = Pose(float(poses.x[i]), float(poses.y[i]), float(poses.theta[i]))
            self._state.update(pose, float(poses.v[i]), float(poses.scene_t[i]))
        self._state_row = row

    def _pose_at(self, t: float) -> Pose:
        poses = self._poses
        x, y, theta = (float(np.interp(t, poses.t, row)) for row in (poses.x, poses.y, self._theta))
        return Pose(x, y, math.remainder(theta, math.tau))

    def _head_at(self, row: int) -> tuple[Angles, float]:
        head = Angles(*self._poses.head[row].tolist())
        return (head, 0.0) if all(map(math.isfinite, head)) else (NO_HEAD, math.inf)
