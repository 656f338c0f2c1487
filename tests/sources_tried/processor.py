"""How much of a processor the program's processes take, and the browser of the page."""

import multiprocessing
from contextlib import suppress

import psutil

from app.clock import monotonic

OF_BROWSER = ("--type=", "--headless")  # how words on the command line of Chromium's processes begin


class ProcessorTimes:
    """The processor times since this was made; processes that begin later are left out."""

    def __init__(self, program: int) -> None:
        """`program` is the process id of the web process."""
        others = {child.pid for process in multiprocessing.active_children() for child in descendants(process.pid or 0)}
        web = psutil.Process(program)
        self._groups = {
            "web": [web],
            "control": [child for child in web.children() if "app.pipeline.process" in command_of(child)],
            "browser": [
                child
                for child in psutil.Process().children(recursive=True)
                if child.pid not in others and any(word.startswith(OF_BROWSER) for word in command_of(child))
            ],
        }
        self._began = monotonic()
        self._before = {name: times_of(group) for name, group in self._groups.items()}

    def shares(self) -> dict[str, float]:
        """Return the share of one processor that each took since then, by name; those that have ended count no more."""
        passed = monotonic() - self._began
        shares = {}
        for name, group in self._groups.items():
            before, now = self._before[name], times_of(group)
            shares[name] = sum(now[pid] - before[pid] for pid in now if pid in before) / passed
        return shares


def descendants(pid: int) -> list[psutil.Process]:
    """Return a process's children, their children, and so on; none of one that has ended."""
    with suppress(psutil.Error):
        return psutil.Process(pid).children(recursive=True)
    return []


def command_of(process: psutil.Process) -> list[str]:
    """Return the command line of a process, empty of one that has ended."""
    with suppress(psutil.Error):
        return process.cmdline()
    return []


def times_of(processes: list[psutil.Process]) -> dict[int, float]:
    """Return the processor time (s) of each process that runs, by its id."""
    times = {}
    for process in processes:
        with suppress(psutil.Error):
            used = process.cpu_times()
            times[process.pid] = used.user + used.system
    return times
