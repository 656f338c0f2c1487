"""From a frame to gestures: project, smooth, differentiate, dead-zone (signal-chain.md, section 3)."""

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.butterworth import low_pass
from app.calibration.vocabulary import DriveParameters
from app.pipeline.channel_health import ChannelHealth
from app.pipeline.linear_rate import PARTS, GuidedRate, linear_projection
from app.pipeline.low_pass import LowPass
from app.pipeline.prior_rates import PriorRates

BASELINE_TIME: Final = 30.0  # s: time constant of the baseline of a displacement gesture
LONGEST_GAP: Final = 1.0  # s: a longer gap between two frames counts as this long


def projection(parameters: DriveParameters) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return weights (n_gestures, n_channels) and offsets (n_gestures,): score = weights . values - offsets, in FS."""
    profile = parameters.profile
    joints = {joint.name: joint for joint in profile.joints}
    weights = np.zeros((len(parameters.gestures), len(profile.layout.channels)))
    offsets = np.zeros(len(parameters.gestures))
    for row, gesture in enumerate(parameters.gestures):
        joint = joints[gesture.joint]
        scale = gesture.direction * joint.sign / joint.span
        weights[row, list(joint.channels)] = scale * np.array(joint.weights)
        offsets[row] = weights[row, list(joint.channels)] @ np.array(joint.mean)
    return weights, offsets


def channels_used(parameters: DriveParameters) -> NDArray[np.bool_]:
    """Return which channels (n_gestures, n_channels) each gesture reads, by its score or by its linear map."""
    uses = projection(parameters)[0] != 0.0
    rows, places = linear_projection(parameters)
    for gesture, place in places.items():
        uses[gesture] |= (rows[place] != 0.0).any(axis=0)
    return np.asarray(uses)


def periods_between(time_step: float, sample_rate: float) -> float:
    """Return how many whole sample periods lie in `time_step` (s): one, or more where frames are missing."""
    periods = time_step * sample_rate
    if periods < 1.5:
        return 1.0  # the usual case, in the shortest way
    return min(float(round(periods)), max(1.0, LONGEST_GAP * sample_rate))


class Decoder:
    """Decodes frame by frame; `score`, `rate`, `drive` and `activation` hold one number per gesture.

    A gesture that reads a bad channel keeps its last score and has activation 0 (safety S5). When the channel is good
    again, the change of the score since then does not count as a movement.
    """

    def __init__(self, parameters: DriveParameters, sample_rate: float) -> None:
        weights, offsets = projection(parameters)
        rows, places = linear_projection(parameters)
        guided = {i: place for i, place in places.items() if place.stop - place.start == PARTS}
        self._weights = np.concatenate((weights, *(rows[place] for place in guided.values())))
        self._offsets: list[float] = offsets.tolist()
        self._uses = channels_used(parameters)
        watched = np.asarray(self._uses.any(axis=0))
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
        self._indices = range(count)
        self._none_bad = [False] * count
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
        self._fresh = True
        self._smooth = [0.0] * count
        self._unseen = [0.0] * count  # FS: change of the scores while their channels were bad
        self._baseline = [0.0] * count
        self.score = [0.0] * count
        self.rate = [0.0] * count
        self.drive = [0.0] * count
        self.activation = [0.0] * count
        self.is_active = False
        """Whether any activation is above 0."""
        self.bad = self._none_bad

    def quieten(self) -> None:
        """Set every activation to 0, as is right without frames."""
        self.is_active = False
        for i in self._indices:
            self.activation[i] = self.drive[i] = 0.0

    def step(self, values: NDArray[np.float32], periods: float) -> None:
        """Decode one frame (n_channels,), `periods` whole sample periods after the frame before."""
        was_bad = self.bad
        bad_channels = self._health.step(values)
        frame = self._health.frame
        if bad_channels is None:
            self.bad = self._none_bad
            trusted = frame
        else:
            self.bad = np.asarray((self._uses & bad_channels).any(axis=1)).tolist()
            trusted = np.where(bad_channels | ~np.isfinite(frame), 0.0, frame)
        if self._prior is not None:
            if periods == 1.0 and self.bad == was_bad and self._prior.is_even:
                products = self._prior.step(trusted)
            else:
                products = self._prior.step_slowly(
                    trusted, [self.bad[i] for i in self._by_prior], [was_bad[i] for i in self._by_prior], periods
                )
        else:
            products = self._weights.dot(trusted).tolist()
            if not math.isfinite(sum(products)):  # a channel that no gesture reads is NaN or infinite
                products = self._weights.dot(np.nan_to_num(trusted, posinf=0.0, neginf=0.0)).tolist()
        was_quiet = not self.is_active
        self.is_active = False
        if self._all_plain and self.bad is was_bad is self._none_bad and not self._fresh:
            self._step_plain(products, self._sample_rate / periods)
            return
        if self._all_prior and self.bad is was_bad is self._none_bad:
            self._step_prior(products)
            self._fresh = False
            return
        self._step_each(products, was_bad, periods, was_quiet)
        self._fresh = False

    def _step_each(self, products: list[float], was_bad: list[bool], periods: float, was_quiet: bool) -> None:
        """Decode a frame gesture by gesture, each in its own way."""
        per_second = self._sample_rate / periods
        for i in self._indices:
            if not self.bad[i]:  # a bad channel: the last score stays
                score = products[i] - self._offsets[i]
                if was_bad[i] and not self._is_displacement[i]:
                    self._unseen[i] += score - self.score[i]
                self.score[i] = score
            if self._is_plain[i]:
                smooth = self._filters[i].step(self.score[i] - self._unseen[i])
                if self._fresh:
                    self._smooth[i] = smooth
                strength = (smooth - self._smooth[i]) * per_second
                self._smooth[i] = smooth
            elif self._is_displacement[i]:
                strength = self._displacement(i, per_second, was_quiet)
            elif i in self._guided:
                guided, place = self._guided[i]
                strength = guided.step(products[place], self.bad[i], was_bad[i], periods, self._sample_rate)
            else:
                strength = products[self._prior_place[i]]
            self.rate[i] = strength
            above = strength - self._dead_zone[i]
            if above <= 0.0 or self.bad[i]:
                self.drive[i] = self.activation[i] = 0.0
            else:
                self.drive[i] = above
                self.activation[i] = min(1.0, above * self._per_range[i])
                self.is_active = True

    def _step_plain(self, products: list[float], per_second: float) -> None:
        """Decode a frame without a bad channel, when every gesture is plain: the usual case, in the shortest way."""
        scores, rates, smooths, drives, activations = self.score, self.rate, self._smooth, self.drive, self.activation
        for i, low_pass_filter in enumerate(self._filters):
            scores[i] = score = products[i] - self._offsets[i]
            smooth = low_pass_filter.step(score - self._unseen[i])
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
        """Decode a frame without a bad channel, when other people's maps decode every gesture."""
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
        smooth = self._filters[i].step(self.score[i] - self._unseen[i])
        if self._fresh:
            self._baseline[i] = smooth
        if was_quiet:
            self._baseline[i] += (smooth - self._baseline[i]) / (per_second * BASELINE_TIME)
        return smooth - self._baseline[i]
