"""Sends bombs to a served demonstration and measures what its web process does meanwhile."""

import threading
from dataclasses import dataclass, field
from pathlib import Path

import httpx
from drills.bombs import Bomb
from drills.results import Watcher, waited
from processes.served_demo import Demo

from app.clock import monotonic

MOST_GROWTH = 150_000_000  # bytes
LONGEST_ANSWER = 0.2  # s
RESET_PEAK = "5"  # proc(5), clear_refs


@dataclass
class Effect:
    """The effect of one bomb: its answer, and the memory and the answers of the web process meanwhile."""

    status: int
    detail: str
    growth: int  # bytes by which the web process was larger at its peak than before
    answers: list[float] = field(default_factory=list)  # s that each other request took, without the machine's delay


def memory(pid: int, what: str) -> int:
    """Return VmRSS or VmHWM (bytes) of a process."""
    lines = Path(f"/proc/{pid}/status").read_text().splitlines()
    return next(int(line.split()[1]) * 1024 for line in lines if line.startswith(what))


class OtherRequests:
    """The requests of another page, one after the other, while the web process reads a file."""

    def __init__(self, demo: Demo, watcher: Watcher) -> None:
        self._client = httpx.Client(base_url=demo.client.base_url, cookies=demo.client.cookies, timeout=60)
        self._pid = demo.process.pid
        self._watcher = watcher
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._ask)
        self.answers: list[float] = []

    def __enter__(self) -> "OtherRequests":
        self._client.get("/limits").raise_for_status()
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ended.set()
        self._thread.join()
        self._client.close()

    def _ask(self) -> None:
        while not self._ended.is_set():
            begun, before = monotonic(), waited(self._pid)
            self._client.get("/limits").raise_for_status()
            ended = monotonic()
            late = self._watcher.late(begun, ended) + waited(self._pid) - before
            self.answers.append(ended - begun - late)
            self._ended.wait(0.01)


def send_bomb(demo: Demo, bomb: Bomb, watcher: Watcher, before: int) -> Effect:
    """Send a bomb; `before` is the memory (bytes) of the web process before the first bomb."""
    pid = demo.process.pid
    Path(f"/proc/{pid}/clear_refs").write_text(RESET_PEAK)
    with OtherRequests(demo, watcher) as others:
        answer = demo.client.post(bomb.address, files=bomb.files, data=bomb.form, timeout=180)
    grown = memory(pid, "VmHWM") - before
    said = answer.json()
    return Effect(answer.status_code, dict(said)["detail"] if answer.is_error else "", grown, others.answers)
