"""Whether the signals change as this body's movements do: an activation is believed only as a movement (S30).

Three kinds of change are none, whatever drives them (docs/decisions/0039): a step, which is still before and after it;
the same movement in all channels of joints that move independently; and an oscillation whose strokes are equal.
"""

# Compiled in a wheel (hatch_build.py).

import math
from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.profile import JointMap
from app.calibration.signal_steps import STEEPNESS, StepTimes, frames_per_check, step_times
from app.calibration.vocabulary import DriveParameters
from app.pipeline.channel_health import SMALLEST_HALF_RANGE

LARGE_FACTOR: Final = 2.0  # of the least step: with a fabric that has steps of its own, a large one is larger
LARGE_STEP: Final = 0.1  # FS: a sudden step that is not believed though it is the first one
NOISE_OF_STEP: Final = 0.29  # of the least step: so large the noise of a change may be
LEAST_SPIKE: Final = 0.08  # FS: a smaller spike does not drive
AGAIN: Final = 5.0  # s within which a further step or spike means a loose line: real fabric has single ones
SUDDEN_STEPS: Final = 2  # so many within this time are not believed
FILTERED_STEPS: Final = 3  # a jerk of a person can look like one
COMMON_TIME: Final = 0.1  # s over which channels are compared; noise averages out over it
COMMON: Final = 0.85  # cosine between a change of all channels and an equal one; single limbs reach 0.55
EVEN: Final = 0.9  # least over greatest change of the joints; people who move all limbs reach 0.87
LEAST_COMMON: Final = 0.02  # half ranges: a smaller change is not compared
LEAST_EVEN: Final = 0.04  # half ranges: the noise of the channels of a joint does not average out
FEWEST_JOINTS: Final = 3  # with fewer independent joints a person may well move all at once
ALIKE_TIME: Final = 0.06  # logarithm of the ratio of two half waves' durations, one of a person differs by 0.1 and more
ALIKE_PEAK: Final = 0.08  # the same of their peaks
MOST_NOISE: Final = 0.04  # of a peak: by so much more they may differ at most because of the noise at rest
LONGEST_PAUSE: Final = 5.0  # s between two half waves of an oscillation
HALF_WAVES: Final = 4  # so many in a row that are alike; people made at most 3
NEXT: Final = 2.0  # half waves, since the last one ended: an oscillation without a next one is over
LONGEST_GAP: Final = 0.05  # s without a frame after which earlier frames are dropped
DOUBT: Final = 2.0  # s for which signals that were no movement are not believed


class HalfWaves:
    """Counts how many half waves of one rate follow each other that are alike in duration and height.

    `dead_zone` and `noise` of the rate, FS/s; `displaced`: whether the signal is a displacement, whose rate is taken.
    """

    def __init__(self, dead_zone: float, noise: float, period: float, *, displaced: bool = False) -> None:
        self._displaced = displaced
        self._edge = dead_zone / 2.0
        self._least = dead_zone
        self._noise = noise
        self._period = period
        self.reset()

    def reset(self) -> None:
        """Forget all half waves."""
        self._sign = 0
        self._place = math.nan  # FS, of a displacement
        self._last = self._t = self._begin = self._peak = 0.0
        self._end = -math.inf
        self._durations = (0.0, 0.0)  # s, of the last half wave and of the one before it
        self._peaks = (0.0, 0.0)
        self.count = 0
        """Half waves in a row that are alike."""

    @property
    def go_on(self) -> bool:
        """Whether enough of them were alike, and the next one may still come."""
        return self.count >= HALF_WAVES and self._t - self._end <= NEXT * self._durations[0]

    def step(self, strength: float) -> None:
        """Take the rate (FS/s) or the displacement (FS), `period` (s) after the last one."""
        self._t += self._period
        rate = strength
        if self._displaced:
            rate = (strength - self._place) / self._period if math.isfinite(self._place) else 0.0
            self._place = strength
        last, edge = self._last, self._edge
        self._last = rate
        if self._sign and rate * self._sign > edge:
            self._peak = max(self._peak, rate * self._sign)
            return
        if self._sign:
            before, now = last * self._sign, rate * self._sign
            self._complete(self._t - self._period * (edge - now) / (before - now))
            self._sign = 0
        if rate > edge or rate < -edge:
            self._sign = 1 if rate > 0.0 else -1
            before, now = last * self._sign, rate * self._sign
            share = (now - edge) / (now - before) if now > before else 0.0
            self._begin = self._t - self._period * min(1.0, share)
            self._peak = now

    def _complete(self, end: float) -> None:
        duration, peak = end - self._begin, self._peak
        pause = self._begin - self._end
        follows = (
            peak > self._least
            and duration > 0.0
            and self._durations[0] > 0.0
            and pause < LONGEST_PAUSE
            and self._are_alike(duration, peak, 0)
        )
        if not follows:
            self.count = 1
        elif self.count < 2 or self._are_alike(duration, peak, 1):
            self.count += 1
        else:
            self.count = 2
        self._durations = duration, self._durations[0]
        self._peaks = peak, self._peaks[0]
        self._end = end

    def _are_alike(self, duration: float, peak: float, which: int) -> bool:
        tolerance = min(MOST_NOISE, self._noise / peak)
        time = abs(math.log(duration / self._durations[which]))
        return time < ALIKE_TIME + tolerance and abs(math.log(peak / self._peaks[which])) < ALIKE_PEAK + tolerance


def _channels_read(joint: JointMap) -> list[int]:
    """Return the channels of a joint that count, which are finite unless they are reported as bad."""
    return [i for i, weight in zip(joint.channels, joint.pca.rates[0], strict=True) if weight] or list(joint.channels)


class _StepKind(NamedTuple):
    """What counts as one kind of step."""

    times: StepTimes
    least: list[float]  # FS, of each joint
    enough: int  # so many lately are not believed
    large: float  # FS: one that is not believed the first time
    least_square: float  # FS^2: a change of all channels with a smaller square sum has no step


def _step_kind(times: StepTimes, least: list[float], enough: int, large: float = math.inf) -> _StepKind:
    return _StepKind(times, least, enough, large, min(least) ** 2)


class MovementCheck:
    """Checks the frames of one parameter set; a joint with a bad channel is not checked."""

    def __init__(self, parameters: DriveParameters, sample_rate: float) -> None:
        profile = parameters.profile
        names = list(dict.fromkeys(gesture.joint for gesture in parameters.gestures))
        joints = [joint for joint in profile.joints if joint.name in names]
        place = {joint.name: i for i, joint in enumerate(joints)}
        self._joint_of = [place[gesture.joint] for gesture in parameters.gestures]
        read = [_channels_read(joint) for joint in joints]
        channels = [i for group in read for i in group]
        self._take = np.array(channels, dtype=np.intp)
        self._starts = np.cumsum([0, *map(len, read)])[:-1]
        self._columns = [np.arange(start, start + len(group)) for start, group in zip(self._starts, read, strict=True)]
        half_range = (np.array(profile.high) - np.array(profile.low))[channels] / 2.0
        spans = np.repeat([joint.span for joint in joints], [len(group) for group in read])
        self.every = frames_per_check(sample_rate)
        period = self.every / sample_rate
        common = max(1, round(COMMON_TIME / period))
        sudden, filtered = step_times(sample_rate)
        self._size = max(common, sudden.whole, filtered.whole) + 1
        self._kinds = (
            _step_kind(sudden, [joint.step for joint in joints], SUDDEN_STEPS, LARGE_STEP),
            _step_kind(filtered, [joint.filtered_step for joint in joints], FILTERED_STEPS),
        )
        self._common = common
        self._ones = np.ones(len(channels))  # the product with it is the sum, in less than half the time
        self._per_span = 1.0 / spans
        self._spans_per_half_range = spans / np.maximum(half_range, SMALLEST_HALF_RANGE)
        self._compares = len(joints) >= FEWEST_JOINTS
        self._masks = [sum(1 << channel for channel in group) for group in read]
        self._counts = [len(group) for group in read]
        self._count = len(channels)
        self._waves = [
            HalfWaves(joint.pca.dead_zone, joint.rest_rate, period, displaced=True)
            if gesture.feature == "displacement"
            else HalfWaves(gesture.dead_zone, joint.rest_rate, period)
            for gesture, joint in ((gesture, joints[place[gesture.joint]]) for gesture in parameters.gestures)
        ]
        self._again = round(AGAIN / period)
        self._doubt = round(DOUBT / period)
        self._gap = max(1.0, LONGEST_GAP * sample_rate)
        self._ring = np.zeros((self._size, len(channels)))  # in spans
        self._rows = list(self._ring)
        self.reset()

    def reset(self) -> None:
        """Forget the past, and what was not believed."""
        self._forget()
        self._now = 0  # checks so far
        self._blind_until = [0] * len(self._starts)  # the check up to which the ring holds a bad channel of the joint
        self._jumps: list[list[int]] = [
            [] for _ in self._starts
        ]  # the checks at which each joint's last jumps were seen
        self._doubt_until = -1
        self._disbelief_until = -1
        self.doubts = False
        """Whether something within the last 2 s was no movement."""
        self.disbelieves = False
        """Whether it would have driven: an oscillation, a common movement, or steps."""

    def _forget(self) -> None:
        self._known = 0  # frames in the ring, up to its size
        self._newest = 0
        for waves in self._waves:
            waves.reset()

    def look(
        self,
        frame: NDArray[np.float32],
        bad: Sequence[bool],
        estimated: int,
        rates: Sequence[float],
        active: bool,
        periods: float,
    ) -> None:
        """Check a frame (n_channels,) and the decoded rates, `every` frames after the last check, or after a gap.

        `bad`: the gestures with bad channels; `estimated`: the channels, as bits, that are estimated from others;
        `active`: whether any gesture is; `periods`: sample periods since the frame before.
        """
        if periods > self._gap:
            self._forget()
        self._now += 1
        self._newest = newest = (self._newest + 1) % self._size
        np.multiply(frame.take(self._take), self._per_span, out=self._rows[newest])
        self._known = min(self._size, self._known + 1)
        if estimated or True in bad:
            lost = {joint for joint, is_bad in zip(self._joint_of, bad, strict=True) if is_bad}
            for joint, mask in enumerate(self._masks):
                if joint in lost or mask & estimated:
                    self._ring[newest, self._columns[joint]] = 0.0
                    self._blind_until[joint] = self._now + self._size
        disbelieves = False
        for waves, rate in zip(self._waves, rates, strict=True):
            waves.step(rate)
            if waves.count >= HALF_WAVES and waves.go_on:
                disbelieves = True
        if self._known == self._size:
            if active and self._compares and self._now >= max(self._blind_until):
                disbelieves |= self._is_common()
            for kind in self._kinds:
                disbelieves |= self._has_steps(kind)
        if disbelieves:
            self._disbelief_until = self._doubt_until = self._now + self._doubt
        self.doubts = self._now < self._doubt_until
        self.disbelieves = self._now < self._disbelief_until

    def _change(self, newer: int, older: int) -> NDArray[np.float64]:
        """Return the change of each channel between the frames of two ages (checks), in spans."""
        newest, rows = self._newest, self._rows
        change: NDArray[np.float64] = rows[newest - newer] - rows[newest - older]
        return change

    def _squares(self, change: NDArray[np.float64]) -> list[float]:
        """Return the squares of a change, summed over the channels of each joint."""
        squares: list[float] = np.add.reduceat(change * change, self._starts).tolist()
        return squares

    def _has_steps(self, kind: _StepKind) -> bool:
        """Return whether a joint had a large step, or a step or spike that makes too many lately."""
        fast, still = kind.times
        change = self._change(still, still + fast)
        if change.dot(change) < kind.least_square:  # at rest: no joint can have a step
            return False
        at = self._squares(change)
        before: list[float] = []
        has_steps = False
        for i, least in enumerate(kind.least):
            if at[i] < least * least or self._now < self._blind_until[i]:
                continue
            before = before or self._squares(self._change(still + fast, 2 * still + fast))
            # Before and after a step the change, squared, is less than this; noise takes part in each change.
            steep = at[i] / STEEPNESS**2 + (NOISE_OF_STEP * least) ** 2
            if steep < before[i]:
                continue
            is_step = steep > self._squares(self._change(0, still))[i]
            if is_step or (at[i] > LEAST_SPIKE * LEAST_SPIKE and self._is_spike(kind, i, steep)):
                is_large = is_step and at[i] > max(kind.large, LARGE_FACTOR * least) ** 2
                has_steps |= self._repeats(i, still, kind.enough) or is_large
        return has_steps

    def _is_spike(self, kind: _StepKind, joint: int, steep: float) -> bool:
        """Return whether a joint returned to where it was before the change, and has been still since then."""
        fast, still = kind.times
        ages = (still - fast, still + fast), (0, still - fast)
        return all(steep > self._squares(self._change(*pair))[joint] for pair in ages)

    def _repeats(self, joint: int, still: int, enough: int) -> bool:
        """Note a step or spike of a joint; return whether it makes `enough` lately."""
        self._doubt_until = self._now + self._doubt
        jumps = self._jumps[joint]
        if jumps and self._now - jumps[-1] <= still:  # the same one, seen from the next frame
            return False
        jumps[:] = [jump for jump in jumps if self._now - jump <= self._again] + [self._now]
        return len(jumps) >= enough

    def _is_common(self) -> bool:
        """Return whether all channels changed alike lately, or all joints by as much, in half ranges."""
        change = self._change(0, self._common) * self._spans_per_half_range
        squares = self._squares(change)
        mean, square = abs(float(change.dot(self._ones))) / self._count, sum(squares) / self._count
        if mean > LEAST_COMMON and mean * mean > COMMON * COMMON * square:
            return True
        each = [square / count for square, count in zip(squares, self._counts, strict=True)]
        least = min(each)
        return least > LEAST_EVEN * LEAST_EVEN and least > EVEN * EVEN * max(each)
