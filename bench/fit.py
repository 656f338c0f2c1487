"""Measures the fit of a calibration."""

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.clock import stopwatch
from bench.chain import RUNS, SAMPLE_RATE
from bench.row import Row
from bench.subject import bench_parameters, bench_signals


def measure_fit() -> list[Row]:
    """Return the time for the fit of ten seconds of free movement at 1 kHz."""
    parameters = bench_parameters(SAMPLE_RATE)
    values = bench_signals(parameters, 10.0)
    fit_profile(CleanRecording.of(parameters.profile.layout, SAMPLE_RATE, values))  # loads the libraries that it uses
    durations = []
    for _ in range(RUNS):
        before = stopwatch()
        fit_profile(CleanRecording.of(parameters.profile.layout, SAMPLE_RATE, values))
        durations.append(stopwatch() - before)
    times = [1e3 * duration for duration in durations]
    return [Row("calibration fit of 10 s at 1 kHz x 52", times, "ms", 100.0, "lower", f"{RUNS} runs")]
