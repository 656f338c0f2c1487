"""Smoothness of a movement's speed: spectral arc length and log dimensionless jerk."""

import math

import numpy as np
from numpy.typing import NDArray

PAD_LEVEL = 4  # zeros are appended, so that the spectrum is sampled 2 ** 4 times as finely
HIGHEST_FREQUENCY = 10.0  # Hz
LEAST_JERK = 1e-6  # dimensionless; a movement from rest to rest has more than 10, rounding errors alone have less
THRESHOLD = 0.05  # of the spectrum's maximum; frequencies beyond the last one above the threshold are noise


def sparc(speed: NDArray[np.float64], sample_rate: float) -> float | None:
    """Return the spectral arc length of a speed profile: at most 0, smoother nearer to 0, None without movement.

    Parameters
    ----------
    speed
        (n,) m/s, evenly sampled.
    sample_rate
        Hz.

    Notes
    -----
    Source: Balasubramanian, Melendez-Calderon, Roby-Brami, Burdet: On the analysis of movement smoothness,
    J NeuroEngineering and Rehabilitation 12:112, 2015.
    """
    if len(speed) < 2 or not np.any(speed):
        return None
    n = 2 ** (math.ceil(math.log2(len(speed))) + PAD_LEVEL)
    spectrum = np.abs(np.fft.rfft(speed, n))
    spectrum /= spectrum.max()
    frequency = np.arange(len(spectrum)) * (sample_rate / n)
    loud = np.flatnonzero((frequency <= HIGHEST_FREQUENCY) & (spectrum >= THRESHOLD))
    if len(loud) == 0 or loud[0] == loud[-1]:
        return None
    spectrum, frequency = spectrum[loud[0] : loud[-1] + 1], frequency[loud[0] : loud[-1] + 1]
    along = np.diff(frequency) / (frequency[-1] - frequency[0])
    return -float(np.sum(np.hypot(along, np.diff(spectrum))))


def log_dimensionless_jerk(speed: NDArray[np.float64], sample_rate: float) -> float | None:
    """Return -ln of a speed profile's dimensionless jerk: smoother nearer to 0, None at a constant speed.

    Parameters
    ----------
    speed
        (n,) m/s, evenly sampled.
    sample_rate
        Hz.

    Notes
    -----
    The squared jerk, integrated over the movement, times duration cubed over peak speed squared. Source as for `sparc`.
    """
    if len(speed) < 3:
        return None
    peak = float(np.max(np.abs(speed)))
    jerk = np.diff(speed, 2) * sample_rate**2
    duration = len(speed) / sample_rate
    if peak == 0.0:
        return None
    dimensionless = duration**3 / peak**2 * float(np.sum(jerk**2)) / sample_rate
    return -math.log(dimensionless) if dimensionless > LEAST_JERK else None
