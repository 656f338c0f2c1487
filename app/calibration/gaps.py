"""Gaps of single channels are filled before a map is fitted: short ones by straight lines, others by the last value.

Only the fitting fills gaps. In the live chain and in `decode` a missing sensor is a fault (safety.md, S5).
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from app.texts import Figure, Text

LONGEST_GAP = 0.2  # s that are bridged
LARGEST_SHARE = 0.01  # of a channel's samples that may be missing from the data to be fitted

Frames = NDArray[np.float64]


def bridge_gaps(values: Frames, sample_rate: float) -> Frames:
    """Return frames (n, n_channels) with gaps of at most 0.2 s filled by straight lines; longer gaps stay NaN.

    A gap at either end of the recording is filled with the nearest sample. Frames without any value (lost frames) do
    not count towards the length of a channel's gap.
    """
    if not np.isnan(values).any():
        return values
    filled = values.copy()
    has_values = ~np.isnan(values).all(axis=1)
    filled[has_values] = _fill_short_gaps(values[has_values], sample_rate)
    return _fill_short_gaps(filled, sample_rate)


def without_gaps(values: NDArray[np.floating], sample_rate: float) -> Frames:
    """Return frames (n, n_channels) without NaN: short gaps as straight lines, longer ones with the last value."""
    return fill_forward(bridge_gaps(np.asarray(values, np.float64), sample_rate))


def fill_forward(values: Frames) -> Frames:
    """Return frames (n, n_channels) with each NaN replaced by the channel's last value, as the decoder does.

    NaN before a channel's first value take that value; a channel without values becomes zero.
    """
    missing = np.isnan(values)
    if not missing.any():
        return values
    rows = np.where(missing, 0, np.arange(len(values))[:, np.newaxis])
    first = np.argmax(~missing, axis=0)
    latest = np.maximum(np.maximum.accumulate(rows, axis=0), first)
    return np.nan_to_num(np.take_along_axis(values, latest, axis=0))


def why_missing(pieces: Sequence[Frames], channel: int, sample_rate: float) -> Text | None:
    """Return in words why too many samples of a channel are missing from the pieces; None when not.

    Lost frames are not counted.
    """
    if any(map(len, pieces)) and not any(np.isnan(piece[:, channel]).any() for piece in pieces):
        return None  # the usual case, answered before the slower search for lost frames
    missing = [np.isnan(piece[~np.isnan(piece).all(axis=1), channel]) for piece in pieces]
    total = sum(len(samples) for samples in missing)
    share = sum(int(samples.sum()) for samples in missing) / max(total, 1)
    if share == 1.0 or not total:
        return Text("calibration-channel-no-numbers")
    longest = max((int(lengths.max(initial=0)) for _, lengths in map(_gaps, missing)), default=0)
    if longest > _longest_gap(sample_rate):
        return Text("calibration-channel-gap", seconds=Figure(longest / sample_rate, 2), most=LONGEST_GAP)
    if share > LARGEST_SHARE:
        return Text("calibration-channel-missing", percent=Figure(100 * share, 1), most=Figure(100 * LARGEST_SHARE))
    return None


def _fill_short_gaps(values: Frames, sample_rate: float) -> Frames:
    missing = np.isnan(values)
    filled = values.copy()
    for column in np.flatnonzero(missing.any(axis=0) & ~missing.all(axis=0)):
        starts, lengths = _gaps(missing[:, column])
        short = lengths <= _longest_gap(sample_rate)
        present = np.flatnonzero(~missing[:, column])
        for start, length in zip(starts[short], lengths[short], strict=True):
            rows = np.arange(start, start + length)
            filled[rows, column] = np.interp(rows, present, values[present, column])
    return filled


def _gaps(missing: NDArray[np.bool_]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return where each run of missing samples (n,) starts, and how many samples it has."""
    edges = np.diff(np.concatenate(([0], missing.astype(np.int8), [0])))
    starts = np.flatnonzero(edges == 1)
    return starts, np.flatnonzero(edges == -1) - starts


def _longest_gap(sample_rate: float) -> int:
    """Return the length of the longest gap that is bridged, in samples."""
    return max(1, round(LONGEST_GAP * sample_rate))
