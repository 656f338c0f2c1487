"""What a step of the signals is: a change at once, with stillness before and after it, as no body moves."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

CHECK_PERIOD: Final = 0.01  # s between two checks; a slower shirt is checked with every frame
TIMES: Final = ((0.02, 0.08), (0.06, 0.2))  # s: of a step, and of stillness before and after it; a body goes on moving
"""Of a sudden step, as of a connector; and of a filtered one, as of a connector behind a low-pass filter."""
STEEPNESS: Final = 4.0  # a step is so many times as large as the change before it, and as that after it


class StepTimes(NamedTuple):
    """The times of a step, in checks."""

    fast: int  # within which it takes place
    still: int  # of stillness, before it and after it

    @property
    def whole(self) -> int:
        """Checks from the beginning of the stillness before a step to the end of that after it."""
        return 2 * self.still + self.fast


def frames_per_check(sample_rate: float) -> int:
    """Return how many frames lie between two checks at a sample rate (Hz)."""
    return max(1, round(CHECK_PERIOD * sample_rate))


def step_times(sample_rate: float) -> list[StepTimes]:
    """Return the times of sudden and of filtered steps at a sample rate (Hz)."""
    period = frames_per_check(sample_rate) / sample_rate
    return [StepTimes(max(1, round(fast / period)), max(2, round(still / period))) for fast, still in TIMES]


def steps_of(values: NDArray[np.float64], channels: Sequence[int], sample_rate: float) -> Iterator[NDArray[np.float64]]:
    """Yield the changes (3, m) of channels after, within and before the time of each kind of step.

    `values` are frames (n, n_channels), of which m have the whole time of a step before them.
    """
    sampled = values[:: frames_per_check(sample_rate), list(channels)]
    for fast, still in step_times(sample_rate):
        oldest = 2 * still + fast
        count = max(0, len(sampled) - oldest)
        of_age = [sampled[oldest - age :][:count] for age in (0, still, still + fast, oldest)]
        yield np.stack([np.linalg.norm(newer - older, axis=1) for newer, older in pairwise(of_age)])
