"""Gaps of single channels: short ones are bridged where a map is fitted, and nowhere else.

The live chain and `decode` never fill a gap: a sensor that is missing there is a fault (safety.md, S5).
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

LONGEST = 0.2  # s of a gap that is bridged
MOST = 0.01  # of a channel's samples that may be missing within what is fitted

Frames = NDArray[np.float64]


def bridge_gaps(values: Frames, sample_rate: float) -> Frames:
    """Return frames (n, n_channels) in which gaps of at most 0.2 s are straight lines; longer ones stay NaN.

    A gap at either end of the recording takes the nearest sample. Frames that were lost altogether do not make the
    gap of a channel longer.
    """
    if not np.isnan(values).any():
        return values
    filled = values.copy()
    has_values = ~np.isnan(values).all(axis=1)
    filled[has_values] = _fill_short_gaps(values[has_values], sample_rate)
    return _fill_short_gaps(filled, sample_rate)


def why_missing(pieces: Sequence[Frames], channel: int, sample_rate: float) -> str:
    """Return why a channel of the pieces that are fitted misses too much, in words; nothing when it does not.

    Frames that were lost altogether are no channel's fault.
    """
    if any(map(len, pieces)) and not any(np.isnan(piece[:, channel]).any() for piece in pieces):
        return ""  # most channels of most recordings: the frames need not be looked through for lost ones
    missing = [np.isnan(piece[~np.isnan(piece).all(axis=1), channel]) for piece in pieces]
    total = sum(len(one) for one in missing)
    share = sum(int(one.sum()) for one in missing) / max(total, 1)
    if share == 1.0 or not total:
        return "gives no numbers"
    longest = max((int(lengths.max(initial=0)) for _, lengths in map(_gaps, missing)), default=0)
    if longest > _most(sample_rate):
        return f"misses {longest / sample_rate:.2f} s at once, and at most {LONGEST:g} s are bridged"
    if share > MOST:
        return f"misses {share:.1%} of its samples, and at most {MOST:.0%} are bridged"
    return ""


def _fill_short_gaps(values: Frames, sample_rate: float) -> Frames:
    missing = np.isnan(values)
    filled = values.copy()
    for column in np.flatnonzero(missing.any(axis=0) & ~missing.all(axis=0)):
        starts, lengths = _gaps(missing[:, column])
        short = lengths <= _most(sample_rate)
        known = np.flatnonzero(~missing[:, column])
        for start, length in zip(starts[short], lengths[short], strict=True):
            rows = np.arange(start, start + length)
            filled[rows, column] = np.interp(rows, known, values[known, column])
    return filled


def _gaps(missing: NDArray[np.bool_]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return where each run of missing samples (n,) starts, and how many samples it has."""
    edges = np.diff(np.concatenate(([0], missing.astype(np.int8), [0])))
    starts = np.flatnonzero(edges == 1)
    return starts, np.flatnonzero(edges == -1) - starts


def _most(sample_rate: float) -> int:
    return max(1, round(LONGEST * sample_rate))
