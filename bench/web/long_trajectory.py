"""Measures an update of a trajectory of 20,000 points against one of 200: bytes to a viewer, and processor time."""

import resource
import statistics
import subprocess
from typing import NamedTuple

import viser

from app.clock import MonotonicClock
from app.geometry import Pose
from app.scene.bridge_secret import SECRET
from app.scene.role_servers import RoleServers
from app.scene.trajectory import SEND_EVERY, STEP, TrajectoryLine
from bench.children import ask, started
from bench.row import Row

SHORT, LONG = 200, 20_000  # points
UPDATES = 200  # measured at the end of each trajectory
EVERY = 0.01  # s between two updates, so that each is sent
ROUNDS = 5
REACH = {"bytes": 1.05, "processor": 1.2}


class Cost(NamedTuple):
    """The cost of one update."""

    bytes: float
    processor: float  # us of the process with the 3D server


def measure_trajectory(rounds: int = ROUNDS, long: int = LONG) -> list[Row]:
    """Return the cost of an update of the long trajectory over that of the short one, median of several rounds.

    Raises
    ------
    RuntimeError
        When the viewer does not start.
    """
    with RoleServers() as servers, started("bench.processes.reading", str(servers.port("patient"))) as viewer:
        try:
            ask(viewer, SECRET)
            view = _TrajectoryView(servers["patient"], viewer)
            found = [view.round(long) for _ in range(rounds)]
            viewer.communicate(timeout=10)
        finally:
            viewer.kill()
    rows = []
    for kind, unit in (("bytes", "bytes"), ("processor", "us")):
        pairs = [(getattr(short, kind), getattr(after, kind)) for short, after in found]
        brief, lengthy = map(statistics.median, zip(*pairs, strict=True))
        what = f"update of a trajectory of {long} points against one of {SHORT}: {kind}"
        details = f"{lengthy:.0f} {unit} against {brief:.0f}, with one viewer; {rounds} rounds"
        rows.append(Row(what, [after / short for short, after in pairs], "x", REACH[kind], "lower", details))
    return rows


class _TrajectoryView:
    def __init__(self, server: viser.ViserServer, viewer: "subprocess.Popen[str]") -> None:
        self._server, self._viewer = server, viewer
        self._trajectory = TrajectoryLine(server)
        self._clock = MonotonicClock()
        self._points = 0
        self._t = 0.0

    def round(self, long: int) -> tuple[Cost, Cost]:
        """Return the cost of an update of the short trajectory, then of the long one."""
        self._trajectory.clear()
        self._points = 0
        short = self._updates(UPDATES)
        while self._points < long - UPDATES:
            self._add(0.0)  # too soon after the last point to be sent
        return short, self._updates(UPDATES)

    def _updates(self, count: int) -> Cost:
        self._add(SEND_EVERY)  # sends the points that wait
        self._server.flush()
        start = self._clock.now() + 0.5
        self._clock.sleep_until(start)
        bytes_before, used_before = int(ask(self._viewer, "bytes")), _used()
        for number in range(count):
            self._clock.sleep_until(start + number * EVERY)
            self._add(SEND_EVERY)
            self._server.flush()
        used = _used() - used_before
        self._clock.sleep_until(self._clock.now() + 0.5)
        return Cost((int(ask(self._viewer, "bytes")) - bytes_before) / count, 1e6 * used / count)

    def _add(self, dt: float) -> None:
        self._t += 1.01 * dt
        self._trajectory.add(Pose(1.2 * STEP * self._points, 0.0, 0.0), self._t)
        self._points += 1


def _used() -> float:
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime
