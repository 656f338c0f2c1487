"""Prepares the pieces of a calibration recording for fitting: checks them and fills missing samples."""

from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import NDArray

from app.calibration.fit.repetitions import Repetition
from app.layout import ShirtLayout

SHORTEST_FREE = 2.0  # s
SHORTEST_REST = 0.5  # s

Frames = NDArray[np.float64]


def check_pieces(
    layout: ShirtLayout,
    sample_rate: float,
    free: Frames,
    rest: Frames | None,
    repetitions: Sequence[Repetition],
    unused: Collection[str],
) -> None:
    """Check that the pieces are long enough and fit the layout.

    Raises
    ------
    ValueError
        One sentence: which piece is wrong, and what to do.
    """
    count = len(layout.channels)
    for what, piece in (("free movement", free), ("rest", rest), *((one.joint, one.values) for one in repetitions)):
        if piece is not None and (piece.ndim != 2 or piece.shape[1] != count):
            raise ValueError(f"the recording of {what} does not have the {count} channels of '{layout.name}'")
    for what, piece, shortest in (("free movement", free, SHORTEST_FREE), ("rest", rest, SHORTEST_REST)):
        if piece is not None and len(piece) < shortest * sample_rate:
            raise ValueError(
                f"the {what} lasts {len(piece) / sample_rate:.2f} s, which is too short for a calibration: "
                f"record at least {shortest:g} s (10 s of free movement and 3 s of rest are usual)"
            )
    for names, known, what in (
        ({one.joint for one in repetitions}, layout.joint_names, "joint"),
        (set(unused), layout.channel_names, "channel"),
    ):
        if strange := sorted(names - set(known)):
            raise ValueError(f"there is no {what} '{strange[0]}' in '{layout.name}': use one of {', '.join(known)}")


def value_range(pieces: Sequence[Frames]) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return the smallest and the largest value of each channel over all pieces; 0 for a channel without values."""
    lows = np.min([np.where(np.isnan(piece), np.inf, piece).min(axis=0) for piece in pieces], axis=0)
    highs = np.max([np.where(np.isnan(piece), -np.inf, piece).max(axis=0) for piece in pieces], axis=0)
    silent = ~np.isfinite(lows)
    lows[silent] = highs[silent] = 0.0
    return tuple(map(float, lows)), tuple(map(float, highs))


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
