"""Measures what lies between a datagram of the shirt and the report of the chair: the parts of a turn of the loop."""

import os
import socket
from collections import defaultdict
from statistics import median

import numpy as np

from app.clock import MonotonicClock, stopwatch
from app.geometry import Pose
from app.hardware.chair.report import ChairReport
from app.hardware.chair.simulator import VirtualChair
from app.hardware.shirt.packet import encode
from app.hardware.shirt.udp import UdpConfig, UdpShirt
from app.messages import NO_CUE
from app.pipeline.chain import Chain
from app.pipeline.safety_gate import Conditions
from app.process.ring import TickRing
from app.recording.writer import Encoder
from bench.children import next_line, started
from bench.datagram import DATAGRAM, datagram_time
from bench.row import Row
from bench.subject import CHANNELS, bench_floorplan, bench_parameters, bench_signals

RUNS = 5
FRAMES = 8_000
SAMPLE_RATE = 1000.0  # Hz
WAIT = 0.002  # s: how long the loop waits for a frame of such a shirt
BATCH = 80  # ticks that the recorder takes at once
ECHOES = 2_000
PARTS = {
    "waking": "waking of a process that waits for a datagram",
    "read": "receiving and decoding a frame",
    "chain": "chain.step",
    "report": "report of the chair",
    "ring": "tick into the ring",
    "recorder": "recorder, for each tick, in a thread of its own",
}


def measure_turn(runs: int = RUNS, frames: int = FRAMES, echoes: int = ECHOES) -> list[Row]:
    """Return the median time of each part of a turn, relative to one loopback datagram."""
    ratios, times = defaultdict(list), defaultdict(list)
    for _ in range(runs):
        datagram = datagram_time()
        found = {"waking": _waking_time(echoes, datagram), **_part_times(frames)}
        for part, time in found.items():
            times[part].append(time)
            ratios[part].append(time / datagram)
    return [
        Row(f"a turn of the loop: {words}", ratios[part], "x", None, "lower", f"{1e6 * median(times[part]):.1f} us")
        for part, words in PARTS.items()
    ]


def _waking_time(echoes: int, datagram: float) -> float:
    """Return the time (s) for which each of two processes is woken, in a datagram's way there and back."""
    with started("bench.processes.echo") as echo, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            address = ("127.0.0.1", int(next_line(echo)))
            durations = []
            for _ in range(echoes):
                before = stopwatch()
                probe.sendto(DATAGRAM, address)
                probe.recv(2048)
                durations.append(stopwatch() - before)
        finally:
            echo.kill()
    return max(0.0, median(durations) - 2 * datagram) / 2


def _part_times(frames: int) -> dict[str, float]:
    """Return the median time (s) of each part, over `frames` turns with an armed virtual chair."""
    parameters = bench_parameters(SAMPLE_RATE)
    values = bench_signals(parameters, frames / SAMPLE_RATE)
    packets = [encode(i, i / SAMPLE_RATE, frame) for i, frame in enumerate(values)]
    chain = Chain(SAMPLE_RATE, parameters, VirtualChair(bench_floorplan(), Pose(-20.0, 0.0, 0.0)))
    conditions = Conditions()
    chain.arm()
    layout = parameters.profile.layout
    shirt = UdpShirt(UdpConfig(kind="udp", port=0, layout=layout, sample_rate=SAMPLE_RATE), MonotonicClock())
    ring = TickRing.create(f"bodydrive-bench-{os.getpid()}")
    encoder = Encoder(b"{}", CHANNELS, len(parameters.gestures))
    took = np.empty((4, len(packets)))
    batches = []
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("127.0.0.1", 0))
        report = ChairReport(*other.getsockname())
        shirt.open()
        try:
            for i, packet in enumerate(packets):
                other.sendto(packet, shirt.address)
                times = [stopwatch()]
                frame = shirt.read(WAIT)
                times.append(stopwatch())
                tick = chain.step(frame, i / SAMPLE_RATE, conditions)
                times.append(stopwatch())
                report.send(tick)
                times.append(stopwatch())
                ring.write(tick, 1, i / SAMPLE_RATE, NO_CUE, 0, 0)
                times.append(stopwatch())
                took[:, i] = np.diff(times)
                other.recv(2048)
                if i % BATCH == BATCH - 1:
                    before = stopwatch()
                    ticks, _ = ring.since(i + 1 - BATCH)
                    encoder.batch(ticks)
                    batches.append((stopwatch() - before) / BATCH)
        finally:
            shirt.close()
            report.close()
            ring.close()
            ring.unlink()
    return {
        **dict(zip(("read", "chain", "report", "ring"), np.median(took, axis=1).tolist(), strict=True)),
        "recorder": median(batches),
    }
