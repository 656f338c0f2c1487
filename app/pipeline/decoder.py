"""From a frame to gestures: project, differentiate, smooth, dead-zone (docs/signal-chain.md, "Decoding one frame")."""

# Compiled in a wheel (hatch_build.py).

from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.calibration.vocabulary import DriveParameters
from app.pipeline.channel_health import ChannelHealth
from app.pipeline.channel_substitution import ChannelSubstitution
from app.pipeline.map_readings import MapReadings
from app.pipeline.projection import projections
from app.pipeline.return_doubt import BASELINE_TIME, ReturnDoubt
from app.signals.butterworth import low_pass

LONGEST_GAP: Final = 1.0  # s: a longer gap between two frames counts as this long


def periods_between(time_step: float, sample_rate: float) -> float:
    """Return how many whole sample periods lie in `time_step` (s): one, or more where frames are missing."""
    periods = time_step * sample_rate
    if periods < 1.5:
        return 1.0  # the usual case, in the shortest way
    longest = max(1.0, LONGEST_GAP * sample_rate)
    return longest if periods > longest + 1.0 else min(float(round(periods)), longest)


class Decoder:
    """Decodes frame by frame; `score`, `rate`, `drive` and `activation` hold one number per gesture.

    A bad channel is replaced by its estimate from the joint's other channels (safety S5). Where the estimate is not
    exact enough, the gestures that read the channel are `bad` and have activation 0.
    """

    def __init__(self, parameters: DriveParameters, sample_rate: float) -> None:
        read = projections(parameters)
        self._sample_rate = sample_rate
        self._is_displacement = [gesture.feature == "displacement" for gesture in parameters.gestures]
        self._has_displacement = any(self._is_displacement)
        self._dead_zone = [gesture.dead_zone for gesture in parameters.gestures]
        self._per_range = [1.0 / (gesture.full - gesture.dead_zone) for gesture in parameters.gestures]
        coefficients = low_pass(parameters.cutoff, sample_rate)
        self._readings = MapReadings(read, self._is_displacement, coefficients, sample_rate)
        watched = np.asarray(read.uses.any(axis=0))
        self._health = ChannelHealth(parameters.profile, watched, sample_rate)
        self._substitution = ChannelSubstitution(parameters)
        self._doubt = ReturnDoubt(parameters, sample_rate)
        self._count = count = len(parameters.gestures)
        self._indices = range(count)
        self.none_bad = [False] * count
        """`bad` while no gesture is."""
        self.reset()

    def reset(self) -> None:
        """Reset all state; the next frame settles the filters."""
        count = self._count
        self._readings.reset()
        self._health.reset()
        self._substitution.reset()
        self._doubt.reset()
        self.estimated = 0
        """Bit i: channel i is bad, and gestures that read it go on with its estimate."""
        self._is_certain = True  # whether no gesture is bad, in doubt, or reads an estimate
        self._fresh = True
        self._baseline = [0.0] * count
        self.score = [0.0] * count
        self.rate = [0.0] * count
        self.drive = [0.0] * count
        self.activation = [0.0] * count
        self.is_active = False
        """Whether any activation is above 0."""
        self.bad = self.none_bad

    def quieten(self) -> None:
        """Set every activation to 0, as is right without frames."""
        self.is_active = False
        for i in self._indices:
            self.activation[i] = self.drive[i] = 0.0

    def step(self, values: NDArray[np.float32], periods: float) -> None:
        """Decode one frame (n_channels,), `periods` whole sample periods after the frame before."""
        bad_channels = self._health.step(values)
        frame = self._health.frame
        was_quiet = not self.is_active
        if bad_channels is not None or self._substitution.is_active:
            frame = self._replace_bad(frame, bad_channels, periods, was_quiet)
        if periods == 1.0 and self._readings.is_even:
            readings = self._readings.step(frame)
        else:
            readings = self._readings.step_slowly(frame, periods)
        self.score, self.rate = readings[: self._count], readings[self._count :]
        self.is_active = False
        if self._is_certain and not self._has_displacement:
            self._activate()
        else:
            self._activate_each(periods, was_quiet)
        self._fresh = False

    def _replace_bad(
        self, frame: NDArray[np.float64], bad: NDArray[np.bool_] | None, periods: float, was_quiet: bool
    ) -> NDArray[np.float64]:
        """Return the frame with estimates in place of bad channels, and update which gestures are bad or in doubt."""
        doubt = self._doubt
        if doubt.exists:
            doubt.fade(periods, was_quiet)
        rows = None if bad is None else bad[np.newaxis]
        filled, _, surprises = self._substitution.fill(frame[np.newaxis], rows, self._health.previous)
        for surprise in surprises:
            doubt.add(surprise.step)
        lost = self._substitution.lost
        if doubt.exists:
            lost = [is_lost or too_large for is_lost, too_large in zip(lost, doubt.are_too_large(), strict=True)]
        self.bad = lost if True in lost else self.none_bad
        self.estimated = sum(1 << channel for channel in self._substitution.replaced)
        self._is_certain = self.bad is self.none_bad and not doubt.exists and not self.estimated
        replaced: NDArray[np.float64] = filled[0]
        return replaced

    def _activate(self) -> None:
        """Activate the gestures by their rates, when every one is certain: the usual case, in the shortest way."""
        drives, activations = self.drive, self.activation
        for i, rate in enumerate(self.rate):
            above = rate - self._dead_zone[i]
            if above <= 0.0:
                drives[i] = activations[i] = 0.0
            else:
                drives[i] = above
                activation = above * self._per_range[i]
                activations[i] = activation if activation < 1.0 else 1.0
                self.is_active = True

    def _activate_each(self, periods: float, was_quiet: bool) -> None:
        """Activate the gestures one by one, each by its rate or its displacement, as far as it is certain."""
        doubts, margins = self._doubt.of_gestures(), self._substitution.margins
        for i in self._indices:
            if self._is_displacement[i]:
                self.rate[i] = self._displacement(i, periods, was_quiet)
            above = self.rate[i] + doubts[i] - margins[i] - self._dead_zone[i]
            if above <= 0.0 or self.bad[i]:
                self.drive[i] = self.activation[i] = 0.0
            else:
                self.drive[i] = above
                self.activation[i] = min(1.0, above * self._per_range[i])
                self.is_active = True

    def _displacement(self, i: int, periods: float, was_quiet: bool) -> float:
        """Return the displacement of the smoothed score from its baseline, FS."""
        smooth = self.rate[i]
        if self._fresh:
            self._baseline[i] = smooth
        if was_quiet:
            self._baseline[i] += (smooth - self._baseline[i]) * periods / (self._sample_rate * BASELINE_TIME)
        return smooth - self._baseline[i]
