"""The whole 3D scene of a session: both roles' pictures follow one chair."""

import math
import threading
from pathlib import Path
from typing import Final

import numpy as np

from app.geometry import Pose
from app.scene.drawing import NOTHING, drawing_of
from app.scene.head_view import NO_HEAD, Angles
from app.scene.plots import Plots
from app.scene.scene_state import SceneState
from app.scene.servers import ROLES, Role, RoleServers
from app.scene.trajectory import Trajectory
from app.scene.views import EyeSettings, Orbit, View
from app.scene.world_view import WorldView
from app.world.floorplan import FloorPlan

CLOCK_WRAPS = 100.0  # s; viser leaves out changes below a hundred-thousandth, so that a clock must stay small
CLOCK_NODE: Final = "/clock"


class Scene:
    """What both roles see. Every method may be called from any thread.

    Parameters
    ----------
    servers
        One for each role.
    models
        Folder of the 3D objects that obstacles name.
    """

    def __init__(self, servers: RoleServers, models: Path | None = None) -> None:
        self._servers = servers
        self._models = models
        self._lock = threading.Lock()
        self._views: dict[Role, WorldView] = {role: WorldView(servers[role]) for role in ROLES}
        self._trajectories = [Trajectory(servers[role]) for role in ROLES]
        self._plots = Plots(servers["clinician"])
        self._clocks = [servers[role].scene.add_frame(CLOCK_NODE, show_axes=False, visible=False) for role in ROLES]
        self._plan: FloorPlan | None = None
        self._drawing = NOTHING
        self._state = SceneState()
        self._pose = Pose(0.0, 0.0, 0.0)
        self._head, self._head_age = NO_HEAD, math.inf
        self._t = math.nan

    @property
    def plots_open(self) -> bool:
        """Return whether the clinician's plots are shown."""
        return self._plots.is_open

    def view(self, role: Role) -> View:
        """Return where a role looks from."""
        return self._views[role].view

    def settings(self, role: Role) -> EyeSettings:
        """Return how a role's eye looks."""
        return self._views[role].settings

    def orbit(self, role: Role) -> Orbit:
        """Return where a role's free camera is."""
        return self._views[role].orbit

    def set_floorplan(self, plan: FloorPlan | None, path_name: str | None) -> None:
        """Draw another floor plan and the path that is to be driven; forgets what was driven.

        Raises
        ------
        ValueError
            When the plan has no path of this name; the scene stays as it was.
        """
        path = None if plan is None or path_name is None else plan.path_named(path_name)
        drawing = self._drawing if plan == self._plan else drawing_of(plan, path, self._models)
        with self._lock:
            self._plan, self._drawing, self._state = plan, drawing, SceneState(plan, path)
            for view in self._views.values():
                view.draw(drawing)
            self._forget_driven()
            self._plots.show_path(plan, path_name)
            self._place(Pose(0.0, 0.0, 0.0) if path is None else path.start, 0.0)
            self._flush()

    def set_view(self, role: Role, view: View, settings: EyeSettings | None = None) -> None:
        """Let a role look from somewhere else, or with other settings."""
        with self._lock:
            self._views[role].look(view, settings)
            self._flush()

    def set_orbit(self, role: Role, orbit: Orbit) -> None:
        """Put a role's free camera somewhere else."""
        with self._lock:
            self._views[role].turn_free(orbit)
            self._flush()

    def open_plots(self, is_open: bool) -> None:
        """Show or hide the clinician's plots."""
        with self._lock:
            self._plots.open(is_open)
            self._flush()

    def new_trial(self) -> None:
        """Take away the trajectory and the error of the trial before, and put up the cones."""
        with self._lock:
            self._forget_driven()
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
        """Put everything where it is at one moment; one whose pose or time is not finite is left out.

        Parameters
        ----------
        pose
            The chair's.
        t
            Monotonic time, s.
        v
            The chair's speed, m/s.
        scene_t
            The scene's time, s: it moves what moves by itself.
        head, head_age
            The head's angles (rad) and their age (s); what is not finite is a head that is not known.
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
        """Put everything where a tick of the control loop says."""
        self.update(
            Pose(float(tick["x"]), float(tick["y"]), float(tick["theta"])),
            float(tick["t"]),
            v=float(tick["v"]),
            scene_t=float(tick["scene_t"]),
            head=Angles(float(tick["head_yaw"]), float(tick["head_pitch"]), float(tick["head_roll"])),
            head_age=float(tick["head_age"]),
        )

    def tell_time(self, now: float, tick_age: float) -> None:
        """Stamp the picture, so that a page can tell a live one from one that stands still.

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

    def _forget_driven(self) -> None:
        for trajectory in self._trajectories:
            trajectory.clear()
        self._plots.clear()

    def _flush(self) -> None:
        for role in ROLES:
            self._servers[role].flush()
