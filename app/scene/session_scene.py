"""The whole 3D scene of a session: both roles' pictures follow one chair."""

import math
import threading
from pathlib import Path
from typing import Final

import numpy as np

from app.geometry import Pose
from app.scene.cameras import EyeSettings, Orbit, View
from app.scene.drawing import NOTHING, prepared_drawing
from app.scene.head_view import NO_HEAD, Angles
from app.scene.plots import Plots
from app.scene.role_servers import ROLES, Role, RoleServers
from app.scene.scene_state import SceneState
from app.scene.trajectory import TrajectoryLine
from app.scene.world_view import WorldView
from app.world.floorplan import FloorPlan

CLOCK_WRAPS = 100.0  # s; viser does not send relative changes below 1e-5, so that the clock's numbers must stay small
CLOCK_NODE: Final = "/clock"


class LiveScene:
    """The pictures of both roles. Every method may be called from any thread.

    Parameters
    ----------
    servers
        The 3D servers of both roles.
    models
        Folder of the 3D objects that obstacles name.
    """

    def __init__(self, servers: RoleServers, models: Path | None = None) -> None:
        self._servers = servers
        self._models = models
        self._lock = threading.Lock()
        self._views: dict[Role, WorldView] = {role: WorldView(servers[role]) for role in ROLES}
        self._trajectories = [TrajectoryLine(servers[role]) for role in ROLES]
        self._plots = Plots(servers["clinician"])
        self._clocks = [servers[role].scene.add_frame(CLOCK_NODE, show_axes=False, visible=False) for role in ROLES]
        self._plan: FloorPlan | None = None
        self._drawing = NOTHING
        self._state = SceneState()
        self._pose = Pose(0.0, 0.0, 0.0)
        self._start: Pose | None = None  # of the path, until the chair first moves in this plan
        self._left_at: Pose | None = None  # where the control loop has the chair until then
        self._head, self._head_age = NO_HEAD, math.inf
        self._t = math.nan

    @property
    def plots_open(self) -> bool:
        """Whether the clinician's plots are shown."""
        return self._plots.is_open

    @property
    def is_watched(self) -> bool:
        """Whether a page shows this scene now."""
        return any(self._servers[role].get_clients() for role in ROLES)

    def view(self, role: Role) -> View:
        """Return the view of a role."""
        return self._views[role].view

    def settings(self, role: Role) -> EyeSettings:
        """Return the eye settings of a role."""
        return self._views[role].settings

    def orbit(self, role: Role) -> Orbit:
        """Return the orbit of a role's free camera."""
        return self._views[role].orbit

    def set_floorplan(self, plan: FloorPlan | None, path_name: str | None) -> None:
        """Draw another floor plan and the path to be driven, and remove the trajectory.

        Raises
        ------
        ValueError
            When the plan has no path of this name; the scene is not changed.
        """
        path = None if plan is None or path_name is None else plan.path_named(path_name)
        drawing = self._drawing if plan == self._plan else prepared_drawing(plan, path, self._models)
        with self._lock:
            self._plan, self._drawing, self._state = plan, drawing, SceneState(plan, path)
            for view in self._views.values():
                view.draw(drawing)
            self._clear_trajectories()
            self._plots.show_path(plan, path_name)
            self._start, self._left_at = None if path is None else path.start, None
            self._place(self._start or Pose(0.0, 0.0, 0.0), 0.0)
            self._flush()

    def set_view(self, role: Role, view: View, settings: EyeSettings | None = None) -> None:
        """Set a role's view, and its eye settings when given."""
        with self._lock:
            self._views[role].set_view(view, settings)
            self._flush()

    def set_orbit(self, role: Role, orbit: Orbit) -> None:
        """Set the orbit of a role's free camera."""
        with self._lock:
            self._views[role].turn_free(orbit)
            self._flush()

    def open_plots(self, is_open: bool) -> None:
        """Show or hide the clinician's plots."""
        with self._lock:
            self._plots.open(is_open)
            self._flush()

    def new_trial(self) -> None:
        """Remove the last trial's trajectory and error, restart the task and stand the cones up."""
        with self._lock:
            self._clear_trajectories()
            self._state.begin_again()
            self._place(self._pose, 0.0)
            self._flush()

    def update(
        self,
        pose: Pose,
        t: float,
        *,
        v: float = 0.0,
        scene_t: float = 0.0,
        head: Angles = NO_HEAD,
        head_age: float = math.inf,
    ) -> None:
        """Update the scene to one moment; does nothing when pose, speed or a time is not finite.

        Parameters
        ----------
        pose
            The chair's pose.
        t
            Monotonic time, s.
        v
            The chair's speed, m/s.
        scene_t
            The scene's time, s, which sets the places of the movers.
        head, head_age
            The head's angles (rad) and their age (s); not finite when no head is known.
        """
        if not all(map(math.isfinite, (*pose, t, v, scene_t))):
            return
        with self._lock:
            self._state.update(pose, v, scene_t)
            dt = t - self._t if math.isfinite(self._t) else 0.0
            self._t = t
            self._head, self._head_age = head, head_age
            self._place(pose, dt)
            for trajectory in self._trajectories:
                trajectory.add(pose, t)
            self._plots.add(pose, t)
            self._flush()

    def follow(self, tick: np.void) -> None:
        """Update the scene to a tick of the control loop."""
        self.update(
            self._placed(Pose(float(tick["x"]), float(tick["y"]), float(tick["theta"]))),
            float(tick["t"]),
            v=float(tick["v"]),
            scene_t=float(tick["scene_t"]),
            head=Angles(float(tick["head_yaw"]), float(tick["head_pitch"]), float(tick["head_roll"])),
            head_age=float(tick["head_age"]),
        )

    def _placed(self, pose: Pose) -> Pose:
        """Return where the pictures show the chair: at the start of the path until it first moves in this plan.

        Before a trial the control loop has the chair where it stood last, in another plan or in none; there may be a
        wall in this one.
        """
        with self._lock:
            if self._start is None or not all(map(math.isfinite, pose)):
                return pose
            if self._left_at is None:
                self._left_at = pose
            if pose == self._left_at:
                return self._start
            self._start = None
            self._clear_trajectories()  # the line begins where the chair is
            return pose

    def send_time(self, now: float, tick_age: float) -> None:
        """Send a time stamp, by which a page knows the age of its picture, and fit the views to the pages' sizes.

        Parameters
        ----------
        now
            Monotonic time, s.
        tick_age
            Time since the newest tick, s.
        """
        with self._lock:
            for clock in self._clocks:
                clock.position = (now % CLOCK_WRAPS, min(tick_age, CLOCK_WRAPS), 0.0)
            for view in self._views.values():
                view.fit_picture()
            self._flush()

    def _place(self, pose: Pose, dt: float) -> None:
        self._pose = pose
        for view in self._views.values():
            view.follow(pose, dt, self._head, self._head_age, self._state)

    def _clear_trajectories(self) -> None:
        for trajectory in self._trajectories:
            trajectory.clear()
        self._plots.clear()

    def _flush(self) -> None:
        for role in ROLES:
            self._servers[role].flush()
