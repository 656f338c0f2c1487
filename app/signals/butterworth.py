"""Coefficients of the causal second-order Butterworth low-pass, the only filter of the signal chain."""

# Compiled in a wheel (hatch_build.py).

import math
from typing import NamedTuple


class Coefficients(NamedTuple):
    """y[k] = b0 x[k] + b1 x[k-1] + b2 x[k-2] - a1 y[k-1] - a2 y[k-2]."""

    b0: float
    b1: float
    b2: float
    a1: float
    a2: float


def low_pass(cutoff: float, sample_rate: float) -> Coefficients:
    """Return the coefficients for `cutoff` (Hz) at `sample_rate` (Hz), by the bilinear transform.

    The -3 dB point is exactly at `cutoff`; a test compares with scipy.signal.butter.

    Raises
    ------
    ValueError
        When the cutoff is not below half the sample rate.
    """
    if not 0 < cutoff < sample_rate / 2:
        raise ValueError(
            f"a cutoff of {cutoff:g} Hz needs a sample rate above {2 * cutoff:g} Hz, and this one is {sample_rate:g} Hz"
        )
    warped = math.tan(math.pi * cutoff / sample_rate)
    norm = 1.0 / (1.0 + math.sqrt(2.0) * warped + warped * warped)
    b0 = warped * warped * norm
    return Coefficients(
        b0,
        2 * b0,
        b0,
        2 * (warped * warped - 1) * norm,
        (1 - math.sqrt(2.0) * warped + warped * warped) * norm,
    )
