"""What a profile keeps of the channels themselves: how they move together, and their noise.

Both are for channels that break later: the other channels of the joint tell what a broken one would show
(`app/pipeline/channel_substitution.py`), and a channel that is much quieter than its noise is stuck
(`app/pipeline/channel_health.py`).
"""

from collections.abc import Sequence

import numpy as np

from app.calibration.gaps import Frames

NOISE_BLOCK = 0.5  # s
QUIET_SHARE = 0.25  # of the blocks that are taken as free of movement: also free movement has its pauses
SECOND_DIFFERENCE = 6.0  # variance of the second difference of white noise, in variances of the noise
DIGITS = 6  # significant digits: more of them only make the document longer


def movement_covariance(channels: Sequence[int], pieces: Sequence[Frames]) -> tuple[tuple[float, ...], ...]:
    """Return the covariance (k, k) of channels over pieces (n, n_channels), each about its own mean.

    Signals drift from piece to piece, and that is no movement.
    """
    used = [piece[:, list(channels)] for piece in pieces if len(piece)]
    centred = [piece - piece.mean(axis=0) for piece in used]
    rows = np.concatenate(centred)
    covariance = rows.T @ rows / len(rows)
    return tuple(tuple(_rounded(value) for value in row) for row in np.maximum(covariance, covariance.T).tolist())


def channel_noise(values: Frames, sample_rate: float) -> tuple[float, ...]:
    """Return the standard deviation of the noise of each channel in frames (n, n_channels), from its quietest quarter.

    Second differences leave drift and slow movement out. In oversampled signals they understate the noise, so that
    fewer channels count as stuck.
    """
    length = min(len(values), max(5, round(NOISE_BLOCK * sample_rate)))
    blocks = values[: len(values) // length * length].reshape(-1, length, values.shape[1])
    deviation = np.sqrt((np.diff(blocks, n=2, axis=1) ** 2).mean(axis=1) / SECOND_DIFFERENCE)
    return tuple(_rounded(value) for value in np.quantile(deviation, QUIET_SHARE, axis=0).tolist())


def _rounded(value: float) -> float:
    return float(f"{value:.{DIGITS}g}")
