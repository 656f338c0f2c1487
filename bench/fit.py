"""Measures the fit of a calibration."""

import statistics

from app.calibration.fit.profile_fit import fit_profile
from app.clock import stopwatch
from bench.chain import RUNS, SAMPLE_RATE
from bench.row import Row
from bench.subject import bench_parameters, bench_signals


def measure_fit() -> list[Row]:
    """Return the time for the fit of ten seconds of free movement at 1 kHz."""
    parameters = bench_parameters(SAMPLE_RATE)
    values = bench_signals(parameters, 10.0)
    durations = []
    for _ in range(RUNS):
        before = stopwatch()
        fit_profile(parameters.profile.layout, SAMPLE_RATE, values)
        durations.append(stopwatch() - before)
    figure = statistics.median(durations) * 1e3
    return [Row("calibration fit of 10 s at 1 kHz x 52", figure, "ms", 100.0, "lower", f"median of {RUNS}")]
