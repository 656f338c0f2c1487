"""The least steps of a joint's signals that are no movement, from what the calibration saw."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from app.calibration.fit.repetitions import Repetition
from app.calibration.gaps import Frames
from app.calibration.steps import STEEPNESS, steps_of


class LeastSteps(NamedTuple):
    """The least steps (FS) of a joint that count."""

    sudden: float
    filtered: float


SMALLEST = LeastSteps(0.03, 0.06)  # smaller ones hardly drive
LARGEST_STEP = 0.3  # FS
QUIET = 0.3  # quantile of the changes of a piece that is taken for its noise: people rest for that part of it
NOISE_FACTOR = 4.5  # of the usual change within the time of a sudden step
TREMBLING = 0.95  # quantile of the changes at rest: a large cycle of a tremor
TREMOR_FACTOR = 2.0  # of the change of such a cycle within the time of a filtered step
MARGIN = 1.2  # of the largest step of the calibration


def least_steps(
    channels: Sequence[int],
    span: float,
    free: Frames,
    rest: Frames | None,
    own: Sequence[Repetition],
    sample_rate: float,
) -> LeastSteps:
    """Return the least steps of a joint, from frames (n, n_channels) of free movement, of rest, and of its prompts."""
    least = list(SMALLEST)
    for piece in (free, rest, *(one.values for one in own)):
        if piece is None:
            continue
        changes = [step / span for step in steps_of(piece[:, list(channels)], sample_rate)]
        for kind, (after, at, before) in enumerate(changes):
            steep = at[at > STEEPNESS * np.maximum(after, before)]
            least[kind] = max(least[kind], MARGIN * float(steep.max(initial=0.0)))
        (_, sudden, _), (_, filtered, _) = changes
        if (piece is free or piece is rest) and len(sudden):  # nobody rests during prompts
            least[0] = max(least[0], NOISE_FACTOR * float(np.quantile(sudden, QUIET)))
        if piece is rest and len(filtered):
            least[1] = max(least[1], TREMOR_FACTOR * float(np.quantile(filtered, TREMBLING)))
    return LeastSteps(*(round(min(one, LARGEST_STEP), 4) for one in least))
