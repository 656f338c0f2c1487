"""How well a map does on labelled frames: in-phase share, hit rate, false activations at rest."""

import numpy as np
from numpy.typing import NDArray

from app.calibration.profile import MapCheck

SHORTEST_REST = 2.0  # s: from less, false activations at rest cannot be told
BESIDE = 0.3  # s: rest does not begin, nor end, right beside a movement, whose edges are as exact as the lag

Array = NDArray[np.float64]


def dead_zone_of(rate: Array, label: NDArray[np.int8], hit_rate: float) -> float:
    """Return the dead-zone (unit of `rate`) above which the share `hit_rate` of the prompted movements lies."""
    return float(np.quantile(rate[label > 0], 1.0 - hit_rate))


def check(
    rate: Array,
    label: NDArray[np.int8],
    repetition: NDArray[np.int_],
    dead_zone: float,
    full: float,
    sample_rate: float,
) -> MapCheck:
    """Return how a map's rate (n,) does.

    Parameters
    ----------
    rate : (n,) array
        FS/s, of frames that the map was not fitted to.
    label : (n,) array
        +1 in the prompted movement, -1 on the way back, 0 at rest.
    repetition : (n,) array
        Frames of one number follow one another in time.
    dead_zone, full : float
        FS/s.
    sample_rate : float
        Hz.
    """
    activation = np.clip((rate - dead_zone) / (full - dead_zone), 0.0, 1.0)
    moving = label > 0
    total = float(activation.sum())
    count, seconds = 0, 0.0
    for name in np.unique(repetition):
        rows = repetition == name
        resting = _at_rest(label[rows], round(BESIDE * sample_rate))
        active = (activation[rows] > 0.0) & resting
        count += int(np.count_nonzero(np.diff(active.astype(np.int8), prepend=0) > 0))
        seconds += float(resting.sum()) / sample_rate
    return MapCheck(
        in_phase=min(1.0, float(activation[moving].sum()) / total) if total > 0.0 else 0.0,
        hit_rate=float((activation[moving] > 0.0).mean()) if moving.any() else 0.0,
        false_per_minute=60.0 * count / seconds if seconds > 0.0 else 0.0,
        false_count=count,
    )


def _at_rest(label: NDArray[np.int8], beside: int) -> NDArray[np.bool_]:
    """Return where (n,) nothing is asked for, and nothing was or will be within `beside` rows."""
    asked = np.concatenate(([0], np.cumsum(label != 0)))
    rows = np.arange(len(label))
    calm: NDArray[np.bool_] = asked[np.minimum(rows + beside + 1, len(label))] == asked[np.maximum(rows - beside, 0)]
    return calm
