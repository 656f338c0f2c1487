"""Measures exports: ten minutes at 1 kHz x 52 in each format, seconds and size."""

import tempfile
import uuid
from pathlib import Path

import numpy as np

from app import __version__
from app.clock import MonotonicClock, stopwatch, utc_now
from app.features.exports.export_material import ExportMaterial
from app.features.exports.forms import FORMS
from app.features.exports.recorded_runs import RecordedRun
from app.features.exports.service import export_steps
from app.messages import NO_CUE, SensorFrame, Tick
from app.process.ring import TickRing
from app.recording.writer import RunWriter
from app.source import STUDY_SOURCE
from bench.row import Row
from bench.subject import bench_parameters

RATE, MINUTES = 1000.0, 10
NOISE_ROWS = 2000
MOST_WAITING = 12_000  # ticks that the recorder has not taken yet; the ring holds 16,384


def measure_exports() -> list[Row]:
    """Return seconds and size of each form of export."""
    rows = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        _record(folder / "run")
        run = RecordedRun(1, 1, "drive", utc_now(), folder / "run", STUDY_SOURCE, None)
        for form in FORMS:
            package = folder / f"{form}.zip"
            before = stopwatch()
            for step in export_steps(ExportMaterial(1, "P-1", (run,), ()), form):
                step(package)
            seconds, size = stopwatch() - before, package.stat().st_size / 1e6
            what = f"export of {MINUTES} min at 1 kHz x 52 as {form}"
            rows.append(Row(what, [seconds], "s", None, "lower", f"{size:.0f} MB"))
    return rows


def _record(folder: Path) -> None:
    parameters = bench_parameters(RATE)
    layout, gestures = parameters.profile.layout, [gesture.name for gesture in parameters.gestures]
    meta = {
        "software": __version__,
        "sample_rate": RATE,
        "layout": layout.model_dump(mode="json"),
        "gestures": gestures,
    }
    ring = TickRing.create(f"bodydrive-bench-{uuid.uuid4().hex}")
    ring.unlink()
    writer = RunWriter(folder, meta, len(layout.channels), len(gestures))
    writer.start(ring, 0, 1)
    clock = MonotonicClock()
    random = np.random.default_rng(1)
    noise = random.normal(0, 0.01, (NOISE_ROWS, len(layout.channels)))
    for i in range(int(MINUTES * 60 * RATE)):
        t = i / RATE
        values = (np.sin(t + np.arange(len(layout.channels))) + noise[i % NOISE_ROWS]).astype(np.float32)
        share = [float(value) for value in values[: len(gestures)]]
        frame = SensorFrame(i, t, t, values)
        tick = Tick(t=t, frame_seq=frame.seq, t_device=t, values=values, score=share, rate=share, activation=share)
        tick.x, tick.y, tick.theta, tick.v = t * 0.3, float(np.sin(t)), t, 0.3
        ring.write(tick, 1, t, NO_CUE, 0, 0)
        while i - writer.rows > MOST_WAITING:
            clock.sleep_until(clock.now() + 0.01)
    writer.close(ring.number)
    ring.close()
    if writer.dropped:
        raise RuntimeError(f"{writer.dropped} ticks of the recording were lost")
