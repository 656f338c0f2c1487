"""Checks a map on labelled frames: in-phase share, hit rate, false activations at rest."""

import numpy as np
from numpy.typing import NDArray

from app.calibration.linear_map import MapCheck

SHORTEST_REST = 2.0  # s: less rest is too short to count false activations in
# s before and after a movement that count neither as rest nor as movement: the lag is not known more exactly, and the
# slow edges of a stroke have no label.
MARGIN = 0.3

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
    """Return the measures of a map's rate against the labels.

    Parameters
    ----------
    rate : (n,) array
        FS/s, of frames that the map was not fitted to.
    label : (n,) array
        +1 in the prompted movement, -1 on the way back, 0 at rest.
    repetition : (n,) array
        Number of the repetition that a frame belongs to; its frames are consecutive.
    dead_zone, full : float
        FS/s.
    sample_rate : float
        Hz.
    """
    activation = np.clip((rate - dead_zone) / (full - dead_zone), 0.0, 1.0)
    moving = label > 0
    count, seconds, total = 0, 0.0, 0.0
    for name in np.unique(repetition):
        rows = repetition == name
        resting = at_rest(label[rows], round(MARGIN * sample_rate))
        active = (activation[rows] > 0.0) & resting
        total += float(activation[rows][resting | (label[rows] != 0)].sum())
        count += int(np.count_nonzero(np.diff(active.astype(np.int8), prepend=0) > 0))
        seconds += float(resting.sum()) / sample_rate
    return MapCheck(
        in_phase=min(1.0, float(activation[moving].sum()) / total) if total > 0.0 else 0.0,
        hit_rate=float((activation[moving] > 0.0).mean()) if moving.any() else 0.0,
        false_per_minute=60.0 * count / seconds if seconds > 0.0 else 0.0,
        false_count=count,
    )


def at_rest(label: NDArray[np.int8], margin: int) -> NDArray[np.bool_]:
    """Return where (n,) no label other than 0 is within `margin` rows before or after."""
    busy = np.concatenate(([0], np.cumsum(label != 0)))
    rows = np.arange(len(label))
    resting: NDArray[np.bool_] = busy[np.minimum(rows + margin + 1, len(label))] == busy[np.maximum(rows - margin, 0)]
    return resting
