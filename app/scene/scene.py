"""The whole 3D scene of a visit: both roles' pictures follow one chair."""

import math
import threading
from typing import Final

import numpy as np

from app.geometry import Pose
from app.scene.plots import Plots
from app.scene.servers import ROLES, Role, RoleServers
from app.scene.trajectory import Trajectory
from app.scene.views import View
from app.scene.world_view import WorldView
from app.world.floorplan import FloorPlan

CLOCK_WRAPS = 100.0  # s; viser leaves out changes below a hundred-thousandth, so that a clock must stay small
CLOCK_NODE: Final = "/clock"


class Scene:
    """What both roles see. Every method may be called from any thread."""

    def __init__(self, servers: RoleServers) -> None:
        self._servers = servers
        self._lock = threading.Lock()
        self._views: dict[Role, WorldView] = {role: WorldView(servers[role]) for role in ROLES}
        self._trajectories = [Trajectory(servers[role]) for role in ROLES]
        self._plots = Plots(servers["clinician"])
        self._clocks = [servers[role].scene.add_frame(CLOCK_NODE, show_axes=False, visible=False) for role in ROLES]
        self._plan: FloorPlan | None = None

    @property
    def plots_open(self) -> bool:
        """Return whether the clinician's plots are shown."""
        return self._plots.is_open

    def view(self, role: Role) -> View:
        """Return where a role looks from."""
        return self._views[role].view

    def set_floorplan(self, plan: FloorPlan | None, path_name: str | None) -> None:
        """Draw another floor plan and the path that is to be driven; forgets what was driven.

        Raises
        ------
        ValueError
            When the plan has no path of this name; the scene stays as it was.
        """
        if plan is not None and path_name is not None:
            plan.path_named(path_name)
        with self._lock:
            self._plan = plan
            for view in self._views.values():
                view.show(plan, path_name)
            for trajectory in self._trajectories:
                trajectory.clear()
            self._plots.show_path(plan, path_name)
            if plan is not None and path_name is not None:
                start = plan.path_named(path_name).start
                for view in self._views.values():
                    view.place(start)
            self._flush()

    def set_view(self, role: Role, view: View) -> None:
        """Let a role look from somewhere else."""
        with self._lock:
            self._views[role].look(view)
            self._flush()

    def open_plots(self, is_open: bool) -> None:
        """Show or hide the clinician's plots."""
        with self._lock:
            self._plots.open(is_open)
            self._flush()

    def new_trial(self) -> None:
        """Take away the trajectory and the error of the trial before."""
        with self._lock:
            for trajectory in self._trajectories:
                trajectory.clear()
            self._plots.clear()
            self._flush()

    def update(self, pose: Pose, t: float) -> None:
        """Put the chair where it is at `t` (monotonic s); a pose that is not finite is left out."""
        if not all(map(math.isfinite, (*pose, t))):
            return
        with self._lock:
            for view in self._views.values():
                view.place(pose)
            for trajectory in self._trajectories:
                trajectory.add(pose, t)
            self._plots.add(pose, t)
            self._flush()

    def follow(self, tick: np.void) -> None:
        """Put the chair where a tick of the control loop says."""
        self.update(Pose(float(tick["x"]), float(tick["y"]), float(tick["theta"])), float(tick["t"]))

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

    def _flush(self) -> None:
        for role in ROLES:
            self._servers[role].flush()
