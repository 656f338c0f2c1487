"""Low-pass filters of a whole recording, and the standard cut-off; the numbers are those of the loop's filter."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.signals.butterworth import low_pass

STANDARD_CUTOFF: Final = 3.0  # Hz, of what drives and of what is fitted: tremor damping


def smooth(samples: NDArray[np.float64], cutoff: float, sample_rate: float) -> NDArray[np.float64]:
    """Return `samples` (n,) or (n, k) filtered by the causal low-pass; `cutoff` and `sample_rate` in Hz.

    The filter starts in the steady state of the first row, so that the rate is zero at the start.
    """
    from scipy.signal import lfilter, lfilter_zi

    c = low_pass(cutoff, sample_rate)
    numerator, denominator = [c.b0, c.b1, c.b2], [1.0, c.a1, c.a2]
    settled = lfilter_zi(numerator, denominator)
    if samples.ndim == 2:
        settled = settled[:, np.newaxis]
    smoothed, _ = lfilter(numerator, denominator, samples, axis=0, zi=settled * samples[0])
    return np.asarray(smoothed, dtype=np.float64)


def slow_average(
    samples: NDArray[np.float64], time_constant: float, sample_rate: float, periods: NDArray[np.float64] | None = None
) -> NDArray[np.float64]:
    """Return the exponential moving average of `samples` (n,) or (n, k), started in the steady state of the first row.

    `time_constant` in s, `sample_rate` in Hz. `periods` (n,): sample periods between each row and the one before it,
    for recordings with missing rows.
    """
    from scipy.signal import lfilter

    stays = float(np.exp(-1.0 / (sample_rate * time_constant)))
    if periods is None or (periods == 1.0).all():
        first = stays * samples[:1]
        followed, _ = lfilter([1.0 - stays], [1.0, -stays], samples, axis=0, zi=first)
        return np.asarray(followed, dtype=np.float64)
    averages = np.empty_like(samples)
    average = samples[0]
    for row, share in enumerate(1.0 - np.exp(-periods / (sample_rate * time_constant))):
        average = average + share * (samples[row] - average)
        averages[row] = average
    return averages
