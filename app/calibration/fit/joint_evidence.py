"""Measures of one joint's map from rest, free movement and repetitions: span, sign, noise, full, cross-talk."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from app.calibration.fit.repetitions import Repetition
from app.signals.low_pass import STANDARD_CUTOFF, smooth

LAG = 0.3  # s by which people move after the cue
SETTLING = 0.3  # s within which the low-pass settles after its first sample
STILLEST = 0.5  # s: without a recording at rest, the noise is that of the stillest window of this length
SHORTEST_PEAK = 0.25  # s: shorter prompts cover a part of a movement only, so that their peak is not used
MOST_SIGNAL_TO_NOISE = 1000.0


@dataclass(frozen=True, slots=True)
class Direction:
    """One joint's axis in the space of its channels."""

    channels: tuple[int, ...]
    weights: NDArray[np.float64]  # (k,), unit length
    mean: NDArray[np.float64]  # (k,)

    def place(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the projection (n,) of frames (n, n_channels) on the axis, in signal units."""
        place: NDArray[np.float64] = (values[:, list(self.channels)] - self.mean) @ self.weights
        return place


@dataclass(frozen=True, slots=True)
class PromptSign:
    """The direction of the prompted movements along the axis."""

    sign: int  # 1 or -1
    agreement: float  # 0.5 (as much movement one way as the other) to 1 (all of it one way)


def with_lag(repetition: Repetition, sample_rate: float) -> slice:
    """Return the rows of the prompted movement, extended by LAG, but by at most half of their number."""
    moving = repetition.moving
    extra = min(round(LAG * sample_rate), (moving.stop - moving.start + 1) // 2)
    return slice(moving.start, min(len(repetition.values), moving.stop + extra))


def percentile_span(place: NDArray[np.float64]) -> float:
    """Return the distance between the 1st and 99th percentile of `place` (n,); the whole range when that is zero."""
    low, high = np.percentile(place, (1, 99))
    return float(high - low) or float(np.ptp(place))


def prompted_span(direction: Direction, repetitions: Sequence[Repetition]) -> float:
    """Return the median span of the repetitions (signal units); drift between repetitions does not enter it."""
    return float(np.median([percentile_span(direction.place(repetition.values)) for repetition in repetitions]))


def prompt_sign(direction: Direction, repetitions: Sequence[Repetition], span: float, sample_rate: float) -> PromptSign:
    """Return the direction of the prompted movements along the axis, by a vote of the repetitions.

    The vote of a repetition is (mean - start) + (end - start) of its place, clipped to one span, so that no repetition
    dominates. The mean is right also when the prompt covers the way back, the end also when the prompt begins during
    the previous way back.
    """
    votes = []
    for repetition in repetitions:
        place = smooth(direction.place(repetition.values), STANDARD_CUTOFF, sample_rate) / span
        stretch = place[with_lag(repetition, sample_rate)]
        votes.append(float(np.clip((stretch.mean() - stretch[0]) + (stretch[-1] - stretch[0]), -1.0, 1.0)))
    total, size = sum(votes), sum(abs(vote) for vote in votes)
    return PromptSign(sign=1 if total >= 0 else -1, agreement=0.5 + 0.5 * abs(total) / size if size else 0.5)


def rate_of(direction: Direction, values: NDArray[np.float64], scale: float, sample_rate: float) -> NDArray[np.float64]:
    """Return the rate (n,) in FS/s of frames (n, n_channels); `scale` is sign / span."""
    return rate_along(direction.place(values), scale, sample_rate)


def rate_along(place: NDArray[np.float64], scale: float, sample_rate: float) -> NDArray[np.float64]:
    """Return the rate (n,) in FS/s of a place (n,) in signal units; `scale` is sign / span."""
    smoothed = smooth(place * scale, STANDARD_CUTOFF, sample_rate)
    return np.diff(smoothed, prepend=smoothed[0]) * sample_rate


def rest_rate(rate: NDArray[np.float64], sample_rate: float, at_rest: bool) -> float:
    """Return the standard deviation of the rate (FS/s) over a rest, or over the stillest half second of a movement."""
    settled = rate[round(SETTLING * sample_rate) :]
    if not len(settled):
        settled = rate
    if at_rest:
        return float(settled.std())
    length = min(len(settled), max(2, round(STILLEST * sample_rate)))
    windows = sliding_window_view(settled, length)[:: max(1, length // 2)]
    return float(windows.std(axis=1).min())


def full_rate(rates: Sequence[NDArray[np.float64]], dead_zone: float) -> float | None:
    """Return the 90th percentile of the rates above the dead-zone (FS/s), None when no rate is above it."""
    active = np.concatenate([rate[rate > dead_zone] for rate in rates])
    return float(np.percentile(active, 90)) if len(active) else None


def repeatability(rates: Sequence[NDArray[np.float64]], sample_rate: float) -> float | None:
    """Return the standard deviation of the repetitions' peak rates over their mean, None for fewer than two."""
    peaks = [float(rate.max()) for rate in rates if len(rate) >= SHORTEST_PEAK * sample_rate]
    mean = float(np.mean(peaks)) if len(peaks) > 1 else 0.0
    return float(np.std(peaks)) / mean if mean > 0 else None


def signal_to_noise(full: float, noise: float) -> float:
    """Return full / noise, at most 1000."""
    return min(MOST_SIGNAL_TO_NOISE, full / noise) if noise > 0 else MOST_SIGNAL_TO_NOISE


def cross_talk(activation: NDArray[np.float64], floor: float = 0.05) -> NDArray[np.float64]:
    """Return each joint's mean activation during each joint's prompts, as a share of that during its own.

    Parameters
    ----------
    activation : (k, k) array
        Mean activation, row: joint that was prompted, column: joint that answered.
    floor : float
        Smallest activation to divide by, for joints that hardly answered their own prompts.
    """
    shares: NDArray[np.float64] = activation / np.maximum(np.diag(activation), floor)
    np.fill_diagonal(shares, 1.0)
    return shares
