"""Measures the time from Stop on the tablet to the first frame that stops the chair, on one machine."""

import http.client
import random
import subprocess
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np

from app.clock import MonotonicClock, monotonic
from app.hardware.chair.key import new_key, write_key
from app.hardware.chair.packet import STOP
from app.session.equipment.pairing import pair_shirt, shirt_key_file
from bench.children import ask, free_ports, next_line, started
from bench.processes.measured_chair import MeasuredChair
from bench.row import Row

RUNS, STOPS = 3, 40  # runs; stops of each kind in each run: a stop takes a second with its arming
REACH = 25.0  # ms
DRIVING = 0.1  # s: longest drive before a stop, of random length, so that stops meet every phase of the loop
FRAME_LIMIT = 2.0  # s to wait for the stop frame
START_LIMIT = 60.0  # s to wait for the first page of a program that starts
LOOK_EVERY = 0.002  # s


def measure_stop(runs: int = RUNS, stops: int = STOPS) -> list[Row]:
    """Return the p99 from sending the command to the frame, and from `POST /control/stop` to the frame."""
    clock, pause = MonotonicClock(), random.Random(1)
    over_link: list[float] = []
    over_http: list[float] = []
    with served(lambda _: []) as (web, chair, port, _):
        address = ("127.0.0.1", port)
        request(address, "GET", "/", START_LIMIT)  # the page with the button is loaded before a stop
        for times, stop in [(over_link, _by_link), (over_http, _by_http)] * (runs * stops):
            ask(web, "arm")
            clock.sleep_until(clock.now() + pause.uniform(0.0, DRIVING))
            times.append(_stopped(chair, clock, lambda stop=stop: stop(web, address)))  # type: ignore[misc]
    return [
        _row("tablet stop to the first stop frame, from the command on the link: p99", over_link, runs),
        _row("tablet stop to the first stop frame, from POST /control/stop: p99", over_http, runs),
    ]


@contextmanager
def served(
    prepare: Callable[[Path], list[str]],
) -> Iterator[tuple[subprocess.Popen[str], MeasuredChair, int, list[str]]]:
    """Yield the web process of `stop_served`, the chair that it drives, the port on which it serves.

    `prepare` is called before with the folder of the clinic; what it returns is yielded, too.
    """
    key = new_key(1)
    with tempfile.TemporaryDirectory() as folder, MeasuredChair(key) as chair:
        key_file = Path(folder) / "1.key"
        write_key(key_file, key)
        prepared = prepare(Path(folder))
        shirt_port, shirt_key = free_ports(1)[0], str(shirt_key_file(Path(folder), pair_shirt(Path(folder)).id))
        places = [str(chair.port), str(key_file), str(shirt_port), shirt_key, folder]
        with (
            started("bench.processes.stop_served", *places) as web,
            started("app.hardware.shirt.sender", "--key-file", shirt_key, "--to", f"127.0.0.1:{shirt_port}") as shirt,
        ):
            try:
                yield web, chair, int(next_line(web)), prepared
            finally:
                web.communicate()
                shirt.terminate()


def _by_link(web: subprocess.Popen[str], _address: tuple[str, int]) -> float:
    return float(ask(web, "stop"))


def _by_http(_web: subprocess.Popen[str], address: tuple[str, int]) -> float:
    return request(address, "POST", "/api/v1/control/stop")


def request(address: tuple[str, int], method: str, path: str, limit: float = FRAME_LIMIT) -> float:
    """Send a request to the web process, wait at most `limit` (s), and return when it was sent (monotonic s)."""
    connection = http.client.HTTPConnection(*address, timeout=limit)
    connection.connect()  # before the time counts: the connection of a page is open already
    before = monotonic()
    connection.request(method, path)
    status = connection.getresponse().status
    connection.close()
    if status != http.client.OK:
        raise RuntimeError(f"the web process of the benchmark answered {method} {path} by {status}")
    return before


def _stopped(chair: MeasuredChair, clock: MonotonicClock, stop: Callable[[], float]) -> float:
    """Stop, and return the time until the first stop frame came (s)."""
    seen = len(chair.commands)
    before = stop()
    while clock.now() < before + FRAME_LIMIT:
        for came, command in chair.commands[seen:]:
            if command.flags & STOP:
                return came - before
        clock.sleep_until(clock.now() + LOOK_EVERY)
    raise RuntimeError("no stop frame came after a stop")


def _row(what: str, times: list[float], runs: int) -> Row:
    milliseconds = 1e3 * np.array(times)
    p99 = [float(np.percentile(run, 99)) for run in np.split(milliseconds, runs)]
    details = (
        f"{runs} runs of {len(times) // runs} stops while armed, shirt at 100 Hz; "
        f"median {np.median(milliseconds):.1f} ms, worst {milliseconds.max():.1f} ms"
    )
    return Row(what, p99, "ms", REACH, "lower", details)
