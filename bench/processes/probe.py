"""Sends a shirt's frames at 1 kHz to the control process and the echo in turn, and measures each answer's time."""

import json
import socket
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np

from app.clock import MonotonicClock, stopwatch
from app.faults import State
from app.hardware.chair.report import REPORT
from app.hardware.shirt.packet import encode
from app.realtime import go_real_time
from bench.subject import bench_parameters, bench_signals

SAMPLE_RATE = 1000.0
REST = 3.0  # s at the beginning in which the chair is armed, not measured
ANSWER_LIMIT = 0.1  # s: the time that a frame without an answer counts
RUNNING_IN = 500  # frames after the rest that are not measured either


def main(shirt_port: int, echo_port: int, report_port: int, seconds: float, result: Path) -> None:
    """Measure for `seconds`, and write the answers' times to `result`."""
    parameters = bench_parameters(SAMPLE_RATE)
    moving = bench_signals(parameters, seconds)
    resting = np.random.default_rng(3).normal(scale=0.002, size=(int(REST * SAMPLE_RATE), moving.shape[1]))
    values = np.concatenate((resting.astype(np.float32), moving))
    frames = [encode(i, i / SAMPLE_RATE, row) for i, row in enumerate(values)]
    with (
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as to_shirt,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as reports,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as to_echo,
    ):
        to_shirt.connect(("127.0.0.1", shirt_port))
        to_echo.connect(("127.0.0.1", echo_port))
        reports.bind(("127.0.0.1", report_port))
        reports.settimeout(ANSWER_LIMIT)
        to_echo.settimeout(ANSWER_LIMIT)
        armed, first = [0], len(resting) + RUNNING_IN

        def through_the_loop(i: int) -> None:
            to_shirt.send(frames[i])
            while True:
                _, _, state, _, seq, *_ = REPORT.unpack(reports.recv(64))
                if seq == i:
                    armed[0] += i >= first and state == State.ARMED
                    return

        def through_the_echo(i: int) -> None:
            to_echo.send(frames[i])
            while to_echo.recv(2048) != frames[i]:
                pass

        loop, echo = np.empty(len(frames)), np.empty(len(frames))
        words = go_real_time()
        clock = MonotonicClock()
        start = clock.now()
        for i in range(len(frames)):
            clock.sleep_until(start + i / SAMPLE_RATE)
            loop[i] = _timed(through_the_loop, i)
            clock.sleep_until(start + (i + 0.5) / SAMPLE_RATE)
            echo[i] = _timed(through_the_echo, i)
    found = {
        "loop": loop[first:].tolist(),
        "echo": echo[first:].tolist(),
        "frames": len(frames) - first,
        "armed": armed[0],
        "words": words,
    }
    result.write_text(json.dumps(found))


def _timed(answer: Callable[[int], None], i: int) -> float:
    before = stopwatch()
    try:
        answer(i)
    except TimeoutError:
        return ANSWER_LIMIT
    return stopwatch() - before


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]), float(sys.argv[4]), Path(sys.argv[5]))
