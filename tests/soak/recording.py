"""`python -m soak.recording`: 8 h recorded in a few minutes, then 20 min in real time; `make long-recording`.

The first one writes the ticks of 8 h at 100 Hz with 52 channels as quickly as the recorder takes them, in a process of
its own. The second one is made by a real control process with the simulated shirt.
"""

import argparse
import asyncio
import os
import subprocess
import sys
import tempfile
import time
import uuid
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import psutil
from processes.running_control import running, tick_with

from app.messages import NO_CUE, Tick
from app.process.ring import RING_SLOTS, TickRing
from app.recording.reader import read_run
from app.recording.writer import RunWriter
from app.texts import Text
from building import make_layout
from folders import ROOT

RATE, CHANNELS, GESTURES = 100, 52, 4
AT_ONCE = RING_SLOTS // 4  # ticks; the recorder follows before the ring is full
SETTLED = 120  # s of the recording, until which memory is taken for good
MOST_GROWTH = 50.0  # MB
PATIENCE = 30.0  # s for the disk; a recorder that loses rows never has them all
SHIRT = {"kind": "simulator", "sample_rate": float(RATE), "seed": 1, "layout": None, "dead_channels": []}


@dataclass(frozen=True)
class Recorded:
    """What a recording came to."""

    rows: int
    gaps: int  # places where a frame is missing in the sequence
    dropped: int
    damage: Text | None
    growth: float  # MB, of the process that records

    @property
    def is_whole(self) -> bool:
        return (self.gaps, self.dropped, self.damage) == (0, 0, None) and self.growth < MOST_GROWTH


def record_quickly(folder: Path, seconds: int) -> Recorded:
    """Record so many seconds of ticks, as quickly as the recorder takes them, in a process of its own."""
    command = [sys.executable, "-m", "soak.recording", "--child", str(folder), str(seconds)]
    environment = {**os.environ, "PYTHONPATH": f"{ROOT}:{ROOT / 'tests'}"}
    answer = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True, env=environment)
    return recorded(folder, float(answer.stdout))


def write_quickly(folder: Path, seconds: int) -> float:
    """Record in this process, and return by how much its memory grew, MB."""
    ring = TickRing.create(f"bodydrive-test-{uuid.uuid4().hex}")
    ring.unlink()
    layout = make_layout(CHANNELS)
    meta = {
        "run_id": "long",
        "layout": layout.model_dump(mode="json"),
        "sample_rate": float(RATE),
        "gestures": ["g"] * GESTURES,
    }
    writer = RunWriter(folder, meta, CHANNELS, GESTURES)
    writer.start(ring, 0, 1)
    values = np.random.default_rng(1).normal(size=(AT_ONCE, CHANNELS)).astype(np.float32)
    tick = Tick(score=[0.0] * GESTURES, rate=[0.0] * GESTURES, activation=[0.0] * GESTURES)
    settled, most = 0.0, 0.0
    for number in range(seconds * RATE):
        tick.t = tick.t_device = number / RATE
        tick.frame_seq, tick.values = number, values[number % AT_ONCE]
        ring.write(tick, 1, number / RATE, NO_CUE, 0, 0)
        if (number + 1) % AT_ONCE == 0:
            until = time.monotonic() + PATIENCE
            while writer.rows <= number and not writer.damage:
                if time.monotonic() > until:
                    raise TimeoutError(f"{writer.rows} of {number + 1} rows are on the disk after {PATIENCE:g} s")
                time.sleep(0.01)
            most = max(most, _memory())
        if number == SETTLED * RATE:
            settled = most = _memory()
    writer.close(ring.number)
    most = max(most, _memory())  # while the segments became one Parquet file
    ring.close()
    return most - (settled or most)


async def _real(folder: Path, seconds: float) -> float:
    async with running() as control:
        await control.call("shirt", config=SHIRT)
        await control.call("body", config={"kind": "person", "skill": "practised", "seed": 1})
        await tick_with(control, lambda tick: tick["has_frame"])
        await control.call("run", run_id="long", folder=str(folder), kind="free", cues=[], meta={})
        process = psutil.Process(control.pid)
        await asyncio.sleep(min(SETTLED, seconds / 2))
        settled = process.memory_info().rss
        await asyncio.sleep(seconds - min(SETTLED, seconds / 2))
        grown = process.memory_info().rss - settled
        await control.call("end_run")
        return grown / 1e6


def record_really(folder: Path, seconds: float) -> Recorded:
    """Let a real control process record the simulated shirt for so long."""
    return recorded(folder, asyncio.run(_real(folder, seconds)))


def recorded(folder: Path, growth: float) -> Recorded:
    """Read a recording and return what it came to."""
    run = read_run(folder, ["t", "has_frame", "frame_seq"])
    frames = run.frames()["frame_seq"].astype(np.int64)
    return Recorded(run.rows, int((np.diff(frames) != 1).sum()), run.dropped, run.damage, growth)


def _memory() -> float:
    return psutil.Process().memory_info().rss / 1e6


def main() -> int:
    """Return 0 when both recordings are whole and memory stayed."""
    parser = argparse.ArgumentParser(prog="python -m soak.recording", description="Long recordings.")
    parser.add_argument("--hours", type=float, default=8.0)
    parser.add_argument("--minutes", type=float, default=20.0)
    parser.add_argument("--child", nargs=2, metavar=("FOLDER", "SECONDS"), help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.child:
        sys.stdout.write(f"{write_quickly(Path(given.child[0]), int(given.child[1]))}\n")
        return 0
    with tempfile.TemporaryDirectory() as folder:
        found = {
            f"{given.hours:g} h, as quickly as it goes": record_quickly(Path(folder, "quick"), int(3600 * given.hours)),
            f"{given.minutes:g} min of a control process": record_really(Path(folder, "real"), 60 * given.minutes),
        }
    for what, one in found.items():
        sys.stdout.write(
            f"{what}: {one.rows} rows, {one.gaps} gaps, {one.dropped} dropped, grown by {one.growth:.1f} MB"
            f"{f'. {one.damage}' if one.damage else ''}\n"
        )
    return int(not all(one.is_whole for one in found.values()))


if __name__ == "__main__":
    sys.exit(main())
