"""The yardstick of the benchmarks: one loopback UDP datagram, measured on the same machine in the same run."""

import socket
import statistics
from collections.abc import Callable

import numpy as np

from app.clock import stopwatch

FRAMES = 20_000
DATAGRAM = bytes(236)  # length of a frame of 52 float32 with header and CRC


def median_duration(call: Callable[[int], object]) -> float:
    """Return the median duration (s) of `FRAMES` calls, each with its number."""
    durations = np.empty(FRAMES)
    for i in range(FRAMES):
        before = stopwatch()
        call(i)
        durations[i] = stopwatch() - before
    return float(np.median(durations))


def datagram_time() -> float:
    """Return the time (s) of one loopback datagram, sent and received: what other times are compared with."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as loop:
        loop.bind(("127.0.0.1", 0))
        address = loop.getsockname()

        def send_and_receive(_: int) -> None:
            loop.sendto(DATAGRAM, address)
            loop.recv(2048)

        return median_duration(send_and_receive)


def against_datagram(measured: Callable[[], float], runs: int) -> tuple[float, list[float]]:
    """Return the median of a time (s) over `runs`, and in each run its ratio to the time of one loopback datagram."""
    times, ratios = [], []
    for _ in range(runs):
        times.append(measured())
        ratios.append(times[-1] / datagram_time())
    return statistics.median(times), ratios
