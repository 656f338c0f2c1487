"""The Butterworth low-pass over a whole recording at once: the same numbers as the loop's filter, faster."""

import numpy as np
from numpy.typing import NDArray
from scipy.signal import lfilter, lfilter_zi

from app.butterworth import low_pass


def smooth(samples: NDArray[np.float64], cutoff: float, sample_rate: float) -> NDArray[np.float64]:
    """Return `samples` (n,) or (n, k) behind the causal low-pass, started as if the first row had lasted for ever.

    `cutoff` and `sample_rate` in Hz. So started, a recording begins with a rate of zero and not with a jump.
    """
    c = low_pass(cutoff, sample_rate)
    numerator, denominator = [c.b0, c.b1, c.b2], [1.0, c.a1, c.a2]
    settled = lfilter_zi(numerator, denominator)
    if samples.ndim == 2:
        settled = settled[:, np.newaxis]
    smoothed, _ = lfilter(numerator, denominator, samples, axis=0, zi=settled * samples[0])
    return np.asarray(smoothed, dtype=np.float64)
