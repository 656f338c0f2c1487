"""What a step of the signals is: a change at once, with stillness before and after it, as no body moves."""

from itertools import pairwise
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

LOOK_PERIOD: Final = 0.01  # s between two looks; slower shirts are looked at frame by frame
STEP_TIME: Final = 0.02  # s within which a step takes place
STILL_TIME: Final = 0.08  # s before and after a step in which a moving body goes on moving
STEEPNESS: Final = 4.0  # a step is so many times as large as the change before it, and as that after it


class StepTimes(NamedTuple):
    """The times of a step in frames."""

    every: int  # frames from one look to the next
    fast: int  # looks within which a step takes place
    still: int  # looks of stillness before and after it


def step_times(sample_rate: float) -> StepTimes:
    """Return the times of a step at a sample rate (Hz)."""
    every = max(1, round(LOOK_PERIOD * sample_rate))
    period = every / sample_rate
    return StepTimes(every, max(1, round(STEP_TIME / period)), max(2, round(STILL_TIME / period)))


def steps_of(values: NDArray[np.float64], sample_rate: float) -> NDArray[np.float64]:
    """Return the changes (3, m) of frames (n, n_channels) after, within and before the time of a step, look by look."""
    every, fast, still = step_times(sample_rate)
    looked = values[::every]
    ages = np.array([0, still, still + fast, 2 * still + fast])
    newest = np.arange(ages[-1], len(looked))
    return np.stack(
        [np.linalg.norm(looked[newest - newer] - looked[newest - older], axis=1) for newer, older in pairwise(ages)]
    )
