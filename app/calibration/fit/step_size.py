"""The least step of a joint's signals that is no movement, from what the calibration saw."""

from collections.abc import Sequence

import numpy as np

from app.calibration.fit.pieces import Frames
from app.calibration.steps import STEEPNESS, steps_of

SMALLEST_STEP = 0.03  # FS: a smaller one hardly drives
LARGEST_STEP = 0.3  # FS
QUIET = 0.3  # quantile of the changes of a piece that is taken for its noise: people rest for that part of it
NOISE_FACTOR = 4.5  # of the usual change within the time of a step
MARGIN = 1.2  # of the largest step of the calibration


def least_step(channels: Sequence[int], span: float, pieces: Sequence[Frames], sample_rate: float) -> float:
    """Return the least step (FS) of a joint that counts, from frames (n, n_channels) of its rest and movement."""
    largest = SMALLEST_STEP
    for piece in pieces:
        after, at, before = steps_of(piece[:, list(channels)] / span, sample_rate)
        if not len(at):
            continue
        seen = at[at > STEEPNESS * np.maximum(after, before)]
        largest = max(largest, NOISE_FACTOR * float(np.quantile(at, QUIET)), MARGIN * float(seen.max(initial=0.0)))
    return round(min(largest, LARGEST_STEP), 4)
