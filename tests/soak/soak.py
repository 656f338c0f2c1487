"""Three viewers of the 3D view for long, one of them stopped: does the web process grow, are the others harmed?"""

import signal
import statistics
from contextlib import ExitStack
from dataclasses import dataclass

import psutil

from app.bench.parts import ask, next_line, started
from app.clock import MonotonicClock
from app.scene.servers import ROLES

VIEWERS = 3
STOPPED = 0  # which one
MOST_GROWTH = 50.0  # MB
LEAST_SHARE = 0.9  # of the poses that came in a second before
COMES_BACK = 10.0  # s after it goes on
FRESH = 1.0  # s: a pose of the present; one that had waited in the sockets is older
FRESH_LOOKS = 5  # one after the other, because the circle's age begins again with each round


@dataclass
class Interval:
    """What happened between two looks."""

    lasted: float  # s
    rates: list[float]  # poses/s of each viewer
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
    def others(self) -> list[int]:
        """Return the viewers that were not stopped."""
        return [viewer for viewer in range(VIEWERS) if viewer != STOPPED]

    @property
    def share(self) -> float:
        """Return the others' poses a second with one stopped, as a share of those before: of the one worst off."""
        return min(self.rate(self.during, one) / self.rate(self.before, one) for one in self.others)

    @property
    def longest_without(self) -> float:
        """Return for how long, in whole looks, an other viewer got no pose at all, s."""
        return max(sum(look.lasted for look in self.during if not look.rates[one]) for one in self.others)


def soak(seconds: float, warm: float, every: float) -> Soaked:
    """Look for `warm` s, stop one viewer for `seconds`, and let it go on; measure every `every` s."""
    clock = MonotonicClock()
    with ExitStack() as stack:
        web = stack.enter_context(started("app.bench.viewers_served"))
        stack.callback(web.kill)
        port = next_line(web)
        viewers = []
        for number in range(VIEWERS):
            viewers.append(stack.enter_context(started("app.bench.viewer_process", port, ROLES[number % len(ROLES)])))
            stack.callback(viewers[-1].kill)
        process = psutil.Process(web.pid)

        def told(number: int) -> tuple[int, int, float]:
            poses, connected, age = ask(viewers[number], "seen").split()
            return int(poses), int(connected), float(age)

        def looks(lasting: float, whom: list[int]) -> list[Interval]:
            found, began, seen = [], clock.now(), {one: told(one)[0] for one in whom}
            end = began + lasting
            while began < end:
                clock.sleep_until(began + min(every, end - began))
                now, counts = clock.now(), {one: told(one)[0] for one in whom}
                rates = [(counts[one] - seen[one]) / (now - began) if one in whom else 0.0 for one in range(VIEWERS)]
                found.append(Interval(now - began, rates, process.memory_info().rss / 1e6))
                began, seen = now, counts
            return found

        everybody = list(range(VIEWERS))
        while not all(told(one)[0] for one in everybody):
            clock.sleep_until(clock.now() + 0.2)
        before = looks(warm, everybody)
        connected = told(STOPPED)[1]
        viewers[STOPPED].send_signal(signal.SIGSTOP)
        during = looks(seconds, [one for one in everybody if one != STOPPED])
        goes_on = clock.now()
        viewers[STOPPED].send_signal(signal.SIGCONT)
        fresh, seen, returned = 0, 0, None
        while fresh < FRESH_LOOKS and clock.now() < goes_on + COMES_BACK:
            clock.sleep_until(clock.now() + 0.1)
            poses, _, age = told(STOPPED)
            fresh = fresh + 1 if poses > seen and age < FRESH else 0
            seen = poses
        if fresh == FRESH_LOOKS:
            returned = clock.now() - goes_on
        return Soaked(before, during, told(STOPPED)[1] > connected, returned)
