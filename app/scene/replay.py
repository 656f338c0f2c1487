"""A trial that is over, in 3D on a server of its own: nobody's live picture changes, and it never passes for one."""

import math
import threading
from pathlib import Path
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.geometry import Pose
from app.scene.drawing import drawing_of
from app.scene.head_view import NO_HEAD, Angles
from app.scene.scene_state import SceneState
from app.scene.servers import quiet_server
from app.scene.trajectory import Trajectory
from app.scene.views import View
from app.scene.world_view import WorldView
from app.world.floorplan import FloorPlan

MOMENT_NODE: Final = "/moment"  # its x is the moment that is shown (s), so that a page can tell
STILL: Final = 0.5  # s between two looks, from which on a head is where it was and does not swing there

Numbers = NDArray[np.float64]


class ReplayPoses(NamedTuple):
    """What was recorded of where everything was; (n,) each, t rising."""

    t: Numbers  # s
    x: Numbers  # m
    y: Numbers  # m
    theta: Numbers  # rad
    v: Numbers  # m/s
    scene_t: Numbers  # s
    head: Numbers  # (n, 3) yaw, pitch, roll, rad; NaN: not known


class Replay:
    """One recorded trial, shown at any of its moments. Every method may be called from any thread.

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
        self._seen = -1  # the last row that the play has taken
        self._t = float(poses.t[0])
        self._server = quiet_server()
        try:
            self._view = WorldView(self._server)
            self._view.draw(drawing_of(plan, path, models))
            self._moment = self._server.scene.add_frame(MOMENT_NODE, show_axes=False, visible=False)
            driven = Trajectory(self._server)
            for t, x, y, theta in zip(poses.t, poses.x, poses.y, poses.theta, strict=True):
                driven.add(Pose(float(x), float(y), float(theta)), float(t))
            self.show(self._t, "chase")
        except BaseException:
            self.stop()
            raise

    @property
    def port(self) -> int:
        """Return the port (on 127.0.0.1) that the server listens on."""
        return self._server.get_port()

    def show(self, t: float, view: View) -> None:
        """Show the moment `t` (s), seen from `view`; a moment beyond the ends is the end."""
        with self._lock:
            poses = self._poses
            t = min(max(t, float(poses.t[0])), float(poses.t[-1]))
            row = int(np.searchsorted(poses.t, t, side="right")) - 1
            self._play_up_to(row)
            if view != self._view.view:
                self._view.look(view)
            self._view.fit_picture()
            passed = abs(t - self._t)
            self._t = t
            self._view.follow(self._pose_at(t), passed or STILL, *self._head_at(row), self._state)
            self._moment.position = (t, 0.0, 0.0)
            self._server.flush()

    def stop(self) -> None:
        """End the server and its threads."""
        self._server.stop()

    def _play_up_to(self, row: int) -> None:
        """Let the task, the cones and the movers have seen all rows up to this one, and none after it."""
        if row < self._seen:
            self._state.begin_again()
            self._seen = -1
        poses = self._poses
        for i in range(self._seen + 1, row + 1):
            pose = Pose(float(poses.x[i]), float(poses.y[i]), float(poses.theta[i]))
            self._state.update(pose, float(poses.v[i]), float(poses.scene_t[i]))
        self._seen = row

    def _pose_at(self, t: float) -> Pose:
        poses = self._poses
        x, y, theta = (float(np.interp(t, poses.t, row)) for row in (poses.x, poses.y, self._theta))
        return Pose(x, y, math.remainder(theta, math.tau))

    def _head_at(self, row: int) -> tuple[Angles, float]:
        head = Angles(*self._poses.head[row].tolist())
        return (head, 0.0) if all(map(math.isfinite, head)) else (NO_HEAD, math.inf)
