"""From a frame to gestures: project, smooth, differentiate, dead-zone (signal-chain.md, section 3)."""

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.butterworth import low_pass
from app.calibration.vocabulary import DriveParameters
from app.pipeline.channel_health import ChannelHealth
from app.pipeline.channel_substitution import ChannelSubstitution
from app.pipeline.linear_rate import PARTS, GuidedRate, linear_projection
from app.pipeline.low_pass import LowPass
from app.pipeline.prior_rates import PriorRates
from app.pipeline.projection import channels_used, projection
from app.pipeline.return_doubt import BASELINE_TIME, ReturnDoubt

LONGEST_GAP: Final = 1.0  # s: a longer gap between two frames counts as this long


def periods_between(time_step: float, sample_rate: float) -> float:
    """Return how many whole sample periods lie in `time_step` (s): one, or more where frames are missing."""
    periods = time_step * sample_rate
    if periods < 1.5:
        return 1.0  # the usual case, in the shortest way
    return min(float(round(periods)), max(1.0, LONGEST_GAP * sample_rate))


class Decoder:
    """Decodes frame by frame; `score`, `rate`, `drive` and `activation` hold one number per gesture.

    A bad channel is replaced by what the joint's other channels say of it (safety S5). Where they do not say it exactly
    enough, the gestures that read it are `bad` and have activation 0.
    """

    def __init__(self, parameters: DriveParameters, sample_rate: float) -> None:
        weights, offsets = projection(parameters)
        rows, places = linear_projection(parameters)
        guided = {i: place for i, place in places.items() if place.stop - place.start == PARTS}
        self._weights = np.concatenate((weights, *(rows[place] for place in guided.values())))
        self._offsets: list[float] = offsets.tolist()
        watched = np.asarray(channels_used(parameters).any(axis=0))
        self._sample_rate = sample_rate
        coefficients = low_pass(parameters.cutoff, sample_rate)
        count = len(parameters.gestures)
        self._filters = [LowPass(coefficients) for _ in range(count)]
        self._is_displacement = [gesture.feature == "displacement" for gesture in parameters.gestures]
        self._dead_zone = [gesture.dead_zone for gesture in parameters.gestures]
        self._per_range = [1.0 / (gesture.full - gesture.dead_zone) for gesture in parameters.gestures]
        self._guided = {
            i: (GuidedRate(coefficients, sample_rate), slice(count + PARTS * k, count + PARTS * (k + 1)))
            for k, i in enumerate(guided)
        }
        self._by_prior = [i for i in places if i not in guided]  # the gestures that other people's maps decode
        self._prior = None
        if self._by_prior:
            parts = np.stack([rows[places[i]] for i in self._by_prior])
            self._prior = PriorRates(self._weights, parts, coefficients, sample_rate)
        self._prior_place = {i: len(self._weights) + k for k, i in enumerate(self._by_prior)}
        special = {*self._guided, *self._by_prior}
        self._is_plain = [not displaced and i not in special for i, displaced in enumerate(self._is_displacement)]
        self._all_plain = all(self._is_plain)
        self._all_prior = len(self._by_prior) == count
        self._health = ChannelHealth(parameters.profile, watched, sample_rate)
        self._substitution = ChannelSubstitution(parameters)
        self._doubt = ReturnDoubt(parameters, sample_rate)
        self._indices = range(count)
        self.none_bad = [False] * count
        """`bad` while no gesture is."""
        self.reset()

    def reset(self) -> None:
        """Reset all state; the next frame settles the filters."""
        count = len(self._filters)
        for low_pass_filter in self._filters:
            low_pass_filter.reset()
        for guided, _ in self._guided.values():
            guided.reset()
        if self._prior is not None:
            self._prior.reset()
        self._health.reset()
        self._substitution.reset()
        self._doubt.reset()
        self.estimated = 0
        """Bit i: channel i is bad, and gestures that read it go on by what its neighbours tell."""
        self._is_certain = True  # whether no gesture is bad, in doubt, or reads an estimate
        self._fresh = True
        self._smooth = [0.0] * count
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
        if self._prior is not None:
            if periods == 1.0 and self._prior.is_even:
                products = self._prior.step(frame)
            else:
                products = self._prior.step_slowly(frame, periods)
        else:
            products = self._weights.dot(frame).tolist()
            if not math.isfinite(sum(products)):  # a channel that no gesture reads is NaN or infinite
                products = self._weights.dot(np.nan_to_num(frame, posinf=0.0, neginf=0.0)).tolist()
        self.is_active = False
        if self._is_certain and not self._fresh:
            if self._all_plain:
                self._step_plain(products, self._sample_rate / periods)
                return
            if self._all_prior:
                self._step_prior(products)
                return
        self._step_each(products, periods, was_quiet)
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

    def _step_each(self, products: list[float], periods: float, was_quiet: bool) -> None:
        """Decode a frame gesture by gesture, each in its own way."""
        per_second = self._sample_rate / periods
        doubts, margins = self._doubt.of_gestures(), self._substitution.margins
        for i in self._indices:
            self.score[i] = products[i] - self._offsets[i]
            if self._is_plain[i]:
                smooth = self._filters[i].step(self.score[i])
                if self._fresh:
                    self._smooth[i] = smooth
                strength = (smooth - self._smooth[i]) * per_second
                self._smooth[i] = smooth
            elif self._is_displacement[i]:
                strength = self._displacement(i, per_second, was_quiet)
            elif i in self._guided:
                guided, place = self._guided[i]
                strength = guided.step(products[place], periods, self._sample_rate)
            else:
                strength = products[self._prior_place[i]]
            self.rate[i] = strength
            above = strength + doubts[i] - margins[i] - self._dead_zone[i]
            if above <= 0.0 or self.bad[i]:
                self.drive[i] = self.activation[i] = 0.0
            else:
                self.drive[i] = above
                self.activation[i] = min(1.0, above * self._per_range[i])
                self.is_active = True

    def _step_plain(self, products: list[float], per_second: float) -> None:
        """Decode a frame in which every gesture is certain and plain: the usual case, in the shortest way."""
        scores, rates, smooths, drives, activations = self.score, self.rate, self._smooth, self.drive, self.activation
        for i, low_pass_filter in enumerate(self._filters):
            scores[i] = score = products[i] - self._offsets[i]
            smooth = low_pass_filter.step(score)
            rates[i] = rate = (smooth - smooths[i]) * per_second
            smooths[i] = smooth
            above = rate - self._dead_zone[i]
            if above <= 0.0:
                drives[i] = activations[i] = 0.0
            else:
                drives[i] = above
                activation = above * self._per_range[i]
                activations[i] = activation if activation < 1.0 else 1.0
                self.is_active = True

    def _step_prior(self, products: list[float]) -> None:
        """Decode a frame in which every gesture is certain, when other people's maps decode every gesture."""
        first = len(products) - len(self.score)
        for i in self._indices:
            self.score[i] = products[i] - self._offsets[i]
            self.rate[i] = rate = products[first + i]
            above = rate - self._dead_zone[i]
            if above <= 0.0:
                self.drive[i] = self.activation[i] = 0.0
            else:
                self.drive[i] = above
                activation = above * self._per_range[i]
                self.activation[i] = activation if activation < 1.0 else 1.0
                self.is_active = True

    def _displacement(self, i: int, per_second: float, was_quiet: bool) -> float:
        """Return the displacement of the smoothed score from its baseline, FS."""
        smooth = self._filters[i].step(self.score[i])
        if self._fresh:
            self._baseline[i] = smooth
        if was_quiet:
            self._baseline[i] += (smooth - self._baseline[i]) / (per_second * BASELINE_TIME)
        return smooth - self._baseline[i]
