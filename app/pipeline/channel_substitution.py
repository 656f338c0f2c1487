"""Estimates bad channels from the other channels of their joints (decisions/0038).

While a channel is bad, its estimate replaces it: the conditional mean, given the joint's good channels, of a normal
distribution with the covariance of the calibration. The estimate begins where the channel ended. When the channel is
good again, the part of its change that the good channels do not explain is removed from it from then on. So whatever
reads the frame, rates or levels, sees no step, neither when a channel breaks nor when it returns. A channel without
good neighbours keeps its last value.
"""

# Compiled in a wheel (hatch_build.py).

import math
from collections.abc import Iterator
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.linear_map import RATE_LAGS
from app.calibration.vocabulary import DriveParameters
from app.pipeline.projection import projections

RIDGE: Final = 0.01  # of each channel's variance: the covariance of a short calibration is not exact
LARGEST_ERROR: Final = 0.1  # of what a gesture's projection moves by: measured on knit (decisions/0038)
SLACK: Final = 0.1  # of the width of a calibrated range: beyond it, nothing is known of how channels move together
LARGEST_LEVEL_ERROR: Final = 0.5  # of the dead-zone: an error of the levels alone must not look like a movement
PLAUSIBLE_DEVIATIONS: Final = 6.0  # of the estimate: a larger unexplained change is not taken for a movement
# FS/s or FS per FS of the error's standard deviation: the activation that an error may cause. The error of a short
# calibration is understated, and a posture is held for long.
MARGINS: Final = {"rate": 1.0, "displacement": 3.0}
MOST_ESTIMATES: Final = 64  # sets of bad channels that are remembered

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]


class Estimate(NamedTuple):
    """How the values of a set of bad channels follow from a frame."""

    channels: NDArray[np.intp]  # (b,) the bad channels
    gain: Array  # (b, n_channels), 0 for every bad channel
    base: Array  # (b,) signal units: what is added where nothing came before
    reach: Array  # (b,) signal units: larger unexplained changes of a channel are no movement
    known_by: NDArray[np.intp]  # the good channels that it follows from
    lost: list[bool]  # per gesture: whether the estimate is too inexact for it
    reading: list[bool]  # per gesture: whether it reads one of the bad channels
    margins: list[float]  # per gesture, FS/s or FS: the activation that the estimate's error may cause


class SubstitutionChange(NamedTuple):
    """From which row of a block on gestures are lost, or have another margin."""

    row: int
    lost: list[bool]  # per gesture
    margins: list[float]  # per gesture, FS/s or FS


class Surprise(NamedTuple):
    """The unexplained part of a channel's change while it was bad: it may have been a movement, or not."""

    row: int  # of the block of frames
    step: Array  # (n_channels,) signal units


class _JointChannels(NamedTuple):
    """The channels of a joint that are checked, and how they move together."""

    channels: NDArray[np.intp]  # (k,)
    mean: Array  # (k,)
    covariance: Array  # (k, k)


class ChannelSubstitution:
    """Replaces bad channels in frames, and removes from channels that return what is not explained.

    Attributes
    ----------
    lost : list of bool
        Per gesture: whether it reads a channel that is bad in the newest frame and not known well enough.
    margins : list of float
        Per gesture: the activation that the error of the estimates may cause, FS/s or FS.
    replaced : list of int
        The channels that are replaced in the newest frame, and read by gestures that go on.
    is_active : bool
        Whether frames are changed at all: a channel is bad, or was.
    """

    def __init__(self, parameters: DriveParameters) -> None:
        profile = parameters.profile
        read = projections(parameters)
        self._uses = read.uses
        watched = np.asarray(self._uses.any(axis=0))
        self._joints = [
            _joint_channels(np.array(joint.channels), np.array(joint.mean), np.array(joint.covariance), watched)
            for joint in profile.joints
        ]
        self._width = np.array(profile.high) - np.array(profile.low)
        self._low: Array = np.array(profile.low) - SLACK * self._width
        self._high: Array = np.array(profile.high) + SLACK * self._width
        self._moving = read.parts[:, : len(RATE_LAGS)].sum(axis=1)  # the projection whose movement counts, per gesture
        self._levels = read.parts[:, len(RATE_LAGS) :]  # those whose levels count
        self._dead_zones = [gesture.dead_zone for gesture in parameters.gestures]
        self._margins = [MARGINS[gesture.feature] for gesture in parameters.gestures]
        self._none_bad = np.zeros(len(watched), dtype=np.bool_)
        self._none_lost = [False] * len(parameters.gestures)
        self._no_margins = [0.0] * len(parameters.gestures)
        self._estimates: dict[bytes, Estimate] = {}
        self.reset()

    def reset(self) -> None:
        """Forget what was bad."""
        self._bad = self._none_bad
        self._offset = np.zeros(len(self._none_bad))
        self._anchor = np.zeros(0)
        self._last: Array | None = None
        self._estimate: Estimate | None = None
        self.lost = self._none_lost
        self.margins = self._no_margins
        self.replaced: list[int] = []
        self.is_active = False

    def fill(
        self, frames: Array, bad: Flags | None, before: NDArray[np.floating] | None
    ) -> tuple[Array, list[SubstitutionChange], list[Surprise]]:
        """Return frames (n, n_channels) with estimates in place of bad channels.

        Parameters
        ----------
        frames : (n, n_channels) array
            Signal units.
        bad : (n, n_channels) array
            Which channels are bad; None: none.
        before : (n_channels,) array
            The frame before the first one, which was good; None at the beginning. Not read while `is_active`.

        Returns
        -------
        frames : (n, n_channels) array
            The frames, all finite.
        changes : list of Change
            For each row in which other gestures are lost than in the row before, or other channels are bad.
        surprises : list of Surprise
            What remains open about the channels that returned.
        """
        filled: Array = np.where(np.isfinite(frames), frames, 0.0) - self._offset
        if not self.is_active:
            self._last = None if before is None else np.where(np.isfinite(before), before, 0.0).astype(np.float64)
            self.is_active = True
        changes: list[SubstitutionChange] = []
        surprises: list[Surprise] = []
        for start, stop in _segments(bad, len(frames)):
            mask = self._none_bad if bad is None else bad[start]
            first = start
            if (mask != self._bad).any():
                surprise = self._change(filled, start, mask)
                if surprise is not None:
                    surprises.append(Surprise(start, surprise))
                changes.append(SubstitutionChange(start, self.lost, self.margins))
                first += 1
            if self._estimate is not None:
                part = filled[first:stop]
                part[:, self._estimate.channels] = part @ self._estimate.gain.T + self._anchor
                changes.extend(self._support(self._estimate, filled[start:stop], start))
            self._last = filled[stop - 1]
        return filled, changes, surprises

    def _support(self, estimate: Estimate, frames: Array, start: int) -> Iterator[SubstitutionChange]:
        """Yield where gestures are lost because an estimate begins or ends to lie beyond what calibration saw."""
        known_by = estimate.known_by
        good: Array = frames[:, known_by]
        within: Array = good.clip(self._low[known_by], self._high[known_by])
        beyond: list[bool] = np.any(good != within, axis=1).tolist()
        for row, is_beyond in enumerate(beyond, start):
            lost = estimate.reading if is_beyond else estimate.lost
            if lost is not self.lost:
                self.lost = lost
                self.replaced = self._replaced(estimate)
                yield SubstitutionChange(row, lost, self.margins)

    def _replaced(self, estimate: Estimate) -> list[int]:
        """Return the channels of an estimate that gestures go on with."""
        going_on: list[bool] = np.any(self._uses[~np.array(self.lost, dtype=np.bool_)], axis=0).tolist()
        return [channel for channel in estimate.channels.tolist() if going_on[channel]]

    def _change(self, filled: Array, row: int, bad: Flags) -> Array | None:
        """Go over to another set of bad channels in a row; return what remains open about those that returned."""
        both = self._estimate_of(self._bad | bad)
        frame = filled[row]
        channels = both.channels
        shift = both.base if self._last is None else self._last[channels] - both.gain @ self._last
        shown = frame.copy()
        frame[channels] = both.gain @ frame + shift
        returned = self._bad & ~bad
        surprise = None
        if returned.any():
            unexplained = np.where(returned, shown - frame, 0.0)
            filled[row + 1 :] -= unexplained
            self._offset = self._offset + unexplained
            reach = np.zeros(len(bad))
            reach[channels] = both.reach
            surprise = np.clip(unexplained, -reach, reach)
        self._bad = bad.copy()
        if bad.any():
            self._estimate = self._estimate_of(bad)
            self._anchor = frame[self._estimate.channels] - self._estimate.gain @ frame
            self.lost, self.margins = self._estimate.lost, self._estimate.margins
            self.replaced = self._replaced(self._estimate)
        else:
            self._estimate, self.lost, self.replaced = None, self._none_lost, []
            self.margins = self._no_margins
        return surprise

    def _estimate_of(self, bad: Flags) -> Estimate:
        key = bad.tobytes()
        if key not in self._estimates:
            if len(self._estimates) >= MOST_ESTIMATES:
                self._estimates.clear()
            self._estimates[key] = self._new_estimate(bad)
        return self._estimates[key]

    def _new_estimate(self, bad: Flags) -> Estimate:
        count = len(bad)
        gain, error = np.zeros((count, count)), np.zeros((count, count))
        base, deviation = np.zeros(count), np.full(count, np.inf)
        reading: list[bool] = np.asarray((self._uses & bad).any(axis=1)).tolist()
        lost = reading.copy()
        for joint in self._joints:
            wrong = bad[joint.channels]
            if not wrong.any():
                continue
            base[joint.channels[wrong]] = joint.mean[wrong]
            gains, errors = _conditional(joint.covariance, wrong)
            bad_channels, good_channels = joint.channels[wrong], joint.channels[~wrong]
            gain[np.ix_(bad_channels, good_channels)] = gains
            base[bad_channels] -= gains @ joint.mean[~wrong]
            error[np.ix_(bad_channels, bad_channels)] = errors
            deviation[bad_channels] = np.sqrt(np.diag(errors))
        margins = [0.0] * len(lost)
        for gesture, is_lost in enumerate(lost):
            if is_lost and np.isfinite(deviation[self._uses[gesture] & bad]).all():
                lost[gesture] = not self._is_known(gesture, error)
                margins[gesture] = self._margins[gesture] * _deviation(self._moving[gesture], error)
        rows = np.flatnonzero(bad)
        reach = np.minimum(PLAUSIBLE_DEVIATIONS * deviation, self._width)
        known_by = np.flatnonzero((gain != 0.0).any(axis=0))
        return Estimate(rows, gain[rows], base[rows], reach[rows], known_by, lost, reading, margins)

    def _is_known(self, gesture: int, error: Array) -> bool:
        """Return whether an error (n_channels, n_channels) of the channels is small in what a gesture reads."""
        row = self._moving[gesture]
        movement = 0.0
        for joint in self._joints:
            part = row[joint.channels]
            movement += float(part @ joint.covariance @ part)
        levels = sum(_deviation(level, error) for level in self._levels[gesture])
        return (
            _deviation(row, error) <= LARGEST_ERROR * math.sqrt(movement)
            and levels <= LARGEST_LEVEL_ERROR * self._dead_zones[gesture]
        )


def _joint_channels(channels: NDArray[np.intp], mean: Array, covariance: Array, watched: Flags) -> _JointChannels:
    checked = watched[channels]
    return _JointChannels(channels[checked], mean[checked], covariance[np.ix_(checked, checked)])


def _conditional(covariance: Array, wrong: Flags) -> tuple[Array, Array]:
    """Return the gains (b, g) with which the good channels of a joint predict the bad ones, and their error (b, b).

    The equations are solved in units of each channel's own movement, so that they do not depend on signal units.
    """
    size = np.sqrt(np.diag(covariance))
    unit = np.where(size > 0.0, size, 1.0)
    shared = covariance / np.outer(unit, unit)
    good = ~wrong
    among = shared[np.ix_(good, good)]
    across = shared[np.ix_(wrong, good)]
    gains = np.linalg.solve(among + RIDGE * np.eye(len(among)), across.T).T
    errors = shared[np.ix_(wrong, wrong)] - gains @ across.T - across @ gains.T + gains @ among @ gains.T
    np.fill_diagonal(errors, np.maximum(np.diag(errors), 0.0))
    scale = unit[wrong]
    return gains * np.outer(scale, 1.0 / unit[good]), errors * np.outer(scale, scale)


def _deviation(row: Array, error: Array) -> float:
    """Return the standard deviation of a projection (n_channels,) of channels whose error has this covariance."""
    return math.sqrt(max(0.0, float(row @ error @ row)))


def _segments(bad: Flags | None, count: int) -> list[tuple[int, int]]:
    """Return the stretches of rows with one set of bad channels."""
    if bad is None or count == 1:
        return [(0, count)]
    edges = (np.flatnonzero((bad[1:] != bad[:-1]).any(axis=1)) + 1).tolist()
    return list(zip([0, *edges], [*edges, count], strict=True))
