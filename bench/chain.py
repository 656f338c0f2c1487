"""Measures a step of the chain, and decoding a recording."""

import statistics

import numpy as np
from numpy.typing import NDArray

from app.calibration.vocabulary import DriveParameters
from app.clock import stopwatch
from app.geometry import Pose
from app.hardware.chair.simulator import VirtualChair
from app.messages import SensorFrame
from app.pipeline.chain import Chain
from app.pipeline.replay.batch import decode_block
from app.pipeline.safety_gate import Conditions
from app.quantities import Hertz
from bench.datagram import FRAMES, against_datagram, median_duration
from bench.row import Row, reach_of
from bench.subject import bench_floorplan, bench_parameters, bench_signals

RUNS = 5
SAMPLE_RATE: Hertz = 1000.0
STEP_REACH = reach_of(2.8, 1.7)  # of one loopback datagram
DECODE_REACH = reach_of(550.0, 1000.0)  # times as fast as real time
QUANTUM = 0.002  # signal units: about the noise of the signals


def measure_chain_step() -> list[Row]:
    """Return the time of `chain.step`, with 100 walls and the gate, relative to one loopback datagram.

    A real sensor is quantised, so that its channels often repeat a value.
    """
    parameters = bench_parameters(SAMPLE_RATE)
    smooth = bench_signals(parameters, FRAMES / SAMPLE_RATE)
    quantised = (np.round(smooth / QUANTUM) * QUANTUM).astype(np.float32)
    return [_chain_row(parameters, smooth, "smooth"), _chain_row(parameters, quantised, "quantised")]


def _chain_row(parameters: DriveParameters, values: NDArray[np.float32], words: str) -> Row:
    frames = [SensorFrame(i, i / SAMPLE_RATE, i / SAMPLE_RATE, frame) for i, frame in enumerate(values)]

    def step_time() -> float:
        chain = Chain(SAMPLE_RATE, parameters, VirtualChair(bench_floorplan(), Pose(-20.0, 0.0, 0.0)))
        chain.arm()
        conditions = Conditions()
        return median_duration(lambda i: chain.step(frames[i], frames[i].t, conditions))

    step, ratios = against_datagram(step_time, RUNS)
    return Row(
        f"chain.step, 52 channels, 100 walls, {words} signals, against one loopback datagram",
        ratios,
        "x",
        STEP_REACH,
        "lower",
        f"{1e6 * step:.1f} us a step, {FRAMES} in each of {RUNS} runs",
    )


def measure_decode() -> list[Row]:
    """Return how many times faster than real time ten minutes at 1 kHz are decoded."""
    parameters = bench_parameters(SAMPLE_RATE)
    values = bench_signals(parameters, 600.0)
    t = np.arange(len(values)) / SAMPLE_RATE
    decode_block(parameters, SAMPLE_RATE, t[:1000], values[:1000])  # loads the libraries that it uses
    durations = []
    for _ in range(RUNS):
        before = stopwatch()
        decode_block(parameters, SAMPLE_RATE, t, values)
        durations.append(stopwatch() - before)
    details = f"{statistics.median(durations):.2f} s for 600 s, {RUNS} runs"
    speeds = [600.0 / duration for duration in durations]
    return [
        Row("decode of 10 min at 1 kHz x 52", speeds, "times as fast as real time", DECODE_REACH, "higher", details)
    ]
