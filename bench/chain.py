"""Measures a step of the chain, and decoding a recording."""

import socket
import statistics
from collections.abc import Callable

import numpy as np

from app.clock import stopwatch
from app.geometry import Pose
from app.hardware.chair.simulator import VirtualChair
from app.messages import SensorFrame
from app.pipeline.chain import Chain
from app.pipeline.replay.batch import decode_block
from app.pipeline.safety_gate import Conditions
from app.quantities import Hertz
from bench.row import Row
from bench.subject import bench_floorplan, bench_parameters, bench_signals

RUNS = 5
FRAMES = 20_000
SAMPLE_RATE: Hertz = 1000.0
DATAGRAM = bytes(236)  # length of a frame of 52 float32 with header and CRC


def measure_chain_step() -> list[Row]:
    """Return the time of `chain.step`, with 100 walls and the gate, relative to one loopback datagram."""
    parameters = bench_parameters(SAMPLE_RATE)
    values = bench_signals(parameters, FRAMES / SAMPLE_RATE)
    frames = [SensorFrame(i, i / SAMPLE_RATE, i / SAMPLE_RATE, frame) for i, frame in enumerate(values)]
    ratios, steps = [], []
    for _ in range(RUNS):
        chain = Chain(SAMPLE_RATE, parameters, VirtualChair(bench_floorplan(), Pose(-20.0, 0.0, 0.0)))
        chain.arm()
        conditions = Conditions()
        step = _median_of(lambda i, c=chain, o=conditions: c.step(frames[i], frames[i].t, o))  # type: ignore[misc]
        steps.append(step)
        ratios.append(step / _datagram_time())
    return [
        Row(
            "chain.step, 52 channels, 100 walls, against one loopback datagram",
            statistics.median(ratios),
            "x",
            4.0,
            "lower",
            f"{statistics.median(steps) * 1e6:.1f} us a step, median of {RUNS} x {FRAMES}",
        )
    ]


def _median_of(call: Callable[[int], object]) -> float:
    durations = np.empty(FRAMES)
    for i in range(FRAMES):
        before = stopwatch()
        call(i)
        durations[i] = stopwatch() - before
    return float(np.median(durations))


def _datagram_time() -> float:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as loop:
        loop.bind(("127.0.0.1", 0))
        address = loop.getsockname()

        def send_and_receive(_: int) -> None:
            loop.sendto(DATAGRAM, address)
            loop.recv(2048)

        return _median_of(send_and_receive)


def measure_decode() -> list[Row]:
    """Return how many times faster than real time ten minutes at 1 kHz are decoded."""
    parameters = bench_parameters(SAMPLE_RATE)
    values = bench_signals(parameters, 600.0)
    t = np.arange(len(values)) / SAMPLE_RATE
    durations = []
    for _ in range(RUNS):
        before = stopwatch()
        decode_block(parameters, SAMPLE_RATE, t, values)
        durations.append(stopwatch() - before)
    duration = statistics.median(durations)
    details = f"{duration:.2f} s for 600 s, median of {RUNS}"
    return [Row("decode of 10 min at 1 kHz x 52", 600.0 / duration, "x real time", 300.0, "higher", details)]
