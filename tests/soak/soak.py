"""Three viewers of the 3D view for long, one of them stopped: does the web process grow, are the others harmed?

Beside them a second web process serves the same to as many as are not stopped. It tells what this machine, with all
else that runs on it, lets through in the same seconds.
"""

import signal
import statistics
import subprocess
from collections.abc import Iterable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from typing import NamedTuple

import psutil

from app.clock import MonotonicClock
from app.scene.role_servers import ROLES
from bench.children import ask, next_line, started

VIEWERS = 3
STOPPED = 0  # which one
OTHERS = tuple(number for number in range(VIEWERS) if number != STOPPED)
MOST_GROWTH = 50.0  # MB
LEAST_SHARE = 0.95  # of the poses that come where nobody is stopped
COMES_BACK = 10.0  # s after it goes on
FRESH = 1.0  # s: a pose of the present; one that had waited in the sockets is older
FRESH_LOOKS = 5  # one after the other, because the circle's age begins again with each round


class Seen(NamedTuple):
    """What a viewer has seen so far."""

    poses: int
    connected: int  # times
    age: float  # s, of the newest pose when it came


@dataclass
class Interval:
    """What happened between two looks."""

    lasted: float  # s
    rates: list[float]  # poses/s of each viewer
    undisturbed: list[float]  # poses/s of those where nobody is stopped
    memory: float  # MB of the web process at its end


@dataclass
class Soaked:
    """All of it."""

    before: list[Interval]  # all viewers look
    during: list[Interval]  # one is stopped
    was_cut_off: bool  # the one that was stopped
    returned: float | None  # s until it saw the present again; None: it did not

    @property
    def growth(self) -> float:
        """Return by how much the web process was ever larger than when the viewer was stopped, MB."""
        return max(interval.memory for interval in self.during) - self.before[-1].memory

    def rate(self, intervals: list[Interval], viewer: int) -> float:
        """Return the median of a viewer's poses a second."""
        return statistics.median(interval.rates[viewer] for interval in intervals)

    @property
    def share(self) -> float:
        """Return the poses of the others as a share of those where nobody is stopped."""
        got = sum(look.lasted * look.rates[one] for look in self.during for one in OTHERS)
        return got / sum(look.lasted * rate for look in self.during for rate in look.undisturbed)

    @property
    def longest_without(self) -> float:
        """Return for how long, in whole looks, an other viewer got no pose at all, s."""
        return max(sum(look.lasted for look in self.during if not look.rates[one]) for one in OTHERS)


def soak(seconds: float, warm: float, every: float, *, compared: bool = True) -> Soaked:
    """Look for `warm` s, stop one viewer for `seconds`, and let it go on; measure every `every` s.

    Unless `compared`, there is no second web process, and no share.
    """
    clock = MonotonicClock()
    with ExitStack() as stack:

        def start(module: str, *arguments: str) -> "subprocess.Popen[str]":
            process = stack.enter_context(started(module, *arguments))
            stack.callback(process.kill)
            return process

        def serve(numbers: Iterable[int]) -> tuple[psutil.Process, list["subprocess.Popen[str]"]]:
            web = start("bench.processes.viewers_served")
            port = next_line(web)
            viewers = [start("bench.processes.viewer_process", port, ROLES[number % len(ROLES)]) for number in numbers]
            return psutil.Process(web.pid), viewers

        web, viewers = serve(range(VIEWERS))
        undisturbed = serve(OTHERS)[1] if compared else []
        while not all(_seen(one).poses for one in [*viewers, *undisturbed]):
            clock.sleep_until(clock.now() + 0.2)

        def looks(lasting: float, whom: Sequence[int]) -> list[Interval]:
            """Look at those of the viewers that can answer, and at all of the undisturbed ones."""
            asked = [*(viewers[number] for number in whom), *undisturbed]
            found, began, before = [], clock.now(), [_seen(one).poses for one in asked]
            end = began + lasting
            while began < end:
                clock.sleep_until(began + min(every, end - began))
                now, after = clock.now(), [_seen(one).poses for one in asked]
                rates = [(b - a) / (now - began) for a, b in zip(before, after, strict=True)]
                of_viewers = dict(zip(whom, rates, strict=False))
                all_rates = [of_viewers.get(number, 0.0) for number in range(VIEWERS)]
                found.append(Interval(now - began, all_rates, rates[len(whom) :], web.memory_info().rss / 1e6))
                began, before = now, after
            return found

        before = looks(warm, range(VIEWERS))
        connected = _seen(viewers[STOPPED]).connected
        viewers[STOPPED].send_signal(signal.SIGSTOP)
        during = looks(seconds, OTHERS)
        viewers[STOPPED].send_signal(signal.SIGCONT)
        returned = _time_to_the_present(clock, viewers[STOPPED])
        return Soaked(before, during, _seen(viewers[STOPPED]).connected > connected, returned)


def _seen(viewer: "subprocess.Popen[str]") -> Seen:
    poses, connected, age = ask(viewer, "seen").split()
    return Seen(int(poses), int(connected), float(age))


def _time_to_the_present(clock: MonotonicClock, viewer: "subprocess.Popen[str]") -> float | None:
    """Return after how long (s) a viewer sees what is now; None when it does not."""
    began = clock.now()
    fresh = poses = 0
    while clock.now() < began + COMES_BACK:
        clock.sleep_until(clock.now() + 0.1)
        seen = _seen(viewer)
        fresh = fresh + 1 if seen.poses > poses and seen.age < FRESH else 0
        poses = seen.poses
        if fresh == FRESH_LOOKS:
            return clock.now() - began
    return None
