"""Whether the signals change as this body's movements do: an activation is believed only as a movement (S30).

Three kinds of change are none, whatever drives them (docs/decisions/0039): a step, which is still before and after it;
the same movement in all channels of joints that move independently; and an oscillation whose strokes are equal.
"""

import math
from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.calibration.profile import JointMap
from app.calibration.steps import STEEPNESS, step_times
from app.calibration.vocabulary import DriveParameters
from app.pipeline.channel_health import SMALLEST_HALF_RANGE

DEFAULT_STEP: Final = 0.035  # FS: least step, where the calibration says nothing about it
LARGE_FACTOR: Final = 2.0  # of the least step: with a fabric that has steps of its own, a large one is larger
LARGE_STEP: Final = 0.1  # FS: a step that is not believed though it is the first one
NOISE_OF_STEP: Final = 0.29  # of the least step: so large the noise of a change may be
LEAST_SPIKE: Final = 0.08  # FS: a smaller spike does not drive
SECOND_STEP: Final = 5.0  # s within which a second step or spike is a loose line and no chance: real fabric has some
COMMON_TIME: Final = 0.1  # s over which channels are compared; noise averages out over it
COMMON: Final = 0.85  # cosine between a change of all channels and an equal one; single limbs reach 0.55
EVEN: Final = 0.8  # least over greatest change of the joints; people who move all limbs reach 0.78
LEAST_COMMON: Final = 0.02  # half ranges: a smaller change is not compared
LEAST_EVEN: Final = 0.04  # half ranges: the noise of the channels of a joint does not average out
FEWEST_JOINTS: Final = 3  # with fewer independent joints a person may well move all at once
ALIKE_TIME: Final = 0.06  # logarithm of the ratio of two half waves' durations, one of a person differs by 0.1 and more
ALIKE_PEAK: Final = 0.08  # the same of their peaks
MOST_NOISE: Final = 0.04  # of a peak: by so much more they may differ at most because of the noise at rest
LONGEST_PAUSE: Final = 0.25  # of two half waves, between them: an oscillation has no rest
HALF_WAVES: Final = 4  # so many in a row that are alike; people made at most 3
LONGEST_GAP: Final = 0.05  # s without a frame after which the past is forgotten
DOUBT: Final = 2.0  # s for which signals that were no movement are not believed


class HalfWaves:
    """Counts how many half waves of one rate follow each other that are alike in duration and height."""

    def __init__(self, dead_zone: float, noise: float, period: float) -> None:
        self._edge = dead_zone / 2.0
        self._least = dead_zone
        self._noise = noise
        self._period = period
        self.reset()

    def reset(self) -> None:
        """Forget all half waves."""
        self._sign = 0
        self._last = self._t = self._begin = self._peak = 0.0
        self._end = self._end_before = -math.inf
        self._durations = (0.0, 0.0)  # s, of the last half wave and of the one before it
        self._peaks = (0.0, 0.0)
        self.count = 0
        """Half waves in a row that are alike."""

    def step(self, rate: float) -> None:
        """Take the rate (FS/s), `period` (s) after the last one."""
        self._t += self._period
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
            and pause < LONGEST_PAUSE * (duration + self._durations[0])
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
        more = min(MOST_NOISE, self._noise / peak)
        time = abs(math.log(duration / self._durations[which]))
        return time < ALIKE_TIME + more and abs(math.log(peak / self._peaks[which])) < ALIKE_PEAK + more


def _channels_read(joint: JointMap) -> list[int]:
    """Return the channels of a joint that count, which are finite unless they are reported as bad."""
    return [i for i, weight in zip(joint.channels, joint.weights, strict=True) if weight] or list(joint.channels)


class MovementCheck:
    """Looks at the frames of one parameter set; a joint with a bad channel is not looked at."""

    def __init__(self, parameters: DriveParameters, sample_rate: float) -> None:
        profile = parameters.profile
        names = list(dict.fromkeys(gesture.joint for gesture in parameters.gestures))
        joints = [joint for joint in profile.joints if joint.name in names]
        place = {joint.name: i for i, joint in enumerate(joints)}
        self._joint_of = [place[gesture.joint] for gesture in parameters.gestures]
        read = [_channels_read(joint) for joint in joints]
        channels = [i for one in read for i in one]
        self._take = np.array(channels, dtype=np.intp)
        self._starts = np.cumsum([0, *map(len, read)])[:-1]
        self._columns = [np.arange(start, start + len(one)) for start, one in zip(self._starts, read, strict=True)]
        half_range = (np.array(profile.high) - np.array(profile.low))[channels] / 2.0
        spans = np.repeat([joint.span for joint in joints], [len(one) for one in read])
        self._least_steps = [joint.step or DEFAULT_STEP for joint in joints]
        self.every, fast, still = step_times(sample_rate)
        period = self.every / sample_rate
        common = max(1, round(COMMON_TIME / period))
        self._size = max(2 * still + fast, common) + 1
        # Ages of the frames between which changes are looked at: after, at and before a step; from before a spike to
        # after it, and after that; and lately.
        self._newer = np.array([0, still, still + fast, still - fast, 0, 0])
        self._older = np.array([still, still + fast, 2 * still + fast, still + fast, still - fast, common])
        self._scale = np.stack([1.0 / spans] * 5 + [1.0 / np.maximum(half_range, SMALLEST_HALF_RANGE)])
        self._compares = len(joints) >= FEWEST_JOINTS
        self._masks = [sum(1 << channel for channel in one) for one in read]
        self._counts = [len(one) for one in read]
        self._count = len(channels)
        self._waves = [
            HalfWaves(gesture.dead_zone, joints[place[gesture.joint]].rest_rate, period)
            for gesture in parameters.gestures
        ]
        self._second = round(SECOND_STEP / period)
        self._doubt = round(DOUBT / period)
        self._still = still
        self._gap = max(1.0, LONGEST_GAP * sample_rate)
        self._ring = np.zeros((self._size, len(channels)))
        self.reset()

    def reset(self) -> None:
        """Forget the past, and what was not believed."""
        self._forget()
        self._now = 0  # looks so far
        self._blind_until = [0] * len(self._starts)  # the look up to which the ring holds a bad channel of the joint
        self._jump_at = [-self._second - 1] * len(self._starts)  # the look at which each joint's last jump was seen
        self._doubt_until = -1
        self._disbelief_until = -1
        self.doubts = False
        """Whether something within the last 2 s was no movement."""
        self.disbelieves = False
        """Whether it would have driven: an oscillation, a common movement, or a second step."""

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
        """Look at a frame (n_channels,) and the decoded rates, `every` frames after the last look, or after a gap.

        `bad`: the gestures with bad channels; `estimated`: the channels, as bits, that others stand in for; `active`:
        whether any gesture is; `periods`: sample periods since the frame before.
        """
        if periods > self._gap:
            self._forget()
        self._now += 1
        self._newest = newest = (self._newest + 1) % self._size
        self._ring[newest] = frame[self._take]
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
            disbelieves |= waves.count >= HALF_WAVES
        if self._known == self._size:
            ring = self._ring
            change = ring[(newest - self._newer) % self._size] - ring[(newest - self._older) % self._size]
            change *= self._scale
            total = float(change[-1].sum())
            change *= change
            after, at, before, across, after_spike, common = np.add.reduceat(change, self._starts, axis=1).tolist()
            if active and self._compares and self._now >= max(self._blind_until):
                disbelieves |= self._is_common(total, common)
            for i, least in enumerate(self._least_steps):
                # Before and after a step the change, squared, is less than this; noise takes part in each change.
                steep = at[i] / STEEPNESS**2 + (NOISE_OF_STEP * least) ** 2
                if at[i] < least * least or steep < before[i] or self._now < self._blind_until[i]:
                    continue
                is_step = steep > after[i]
                if is_step or (at[i] > LEAST_SPIKE * LEAST_SPIKE and steep > max(across[i], after_spike[i])):
                    is_large = is_step and at[i] > max(LARGE_STEP, LARGE_FACTOR * least) ** 2
                    disbelieves |= self._repeats(i) or is_large
        if disbelieves:
            self._disbelief_until = self._doubt_until = self._now + self._doubt
        self.doubts = self._now < self._doubt_until
        self.disbelieves = self._now < self._disbelief_until

    def _repeats(self, joint: int) -> bool:
        """Note a step or spike of a joint; return whether it is not the first one lately."""
        since = self._now - self._jump_at[joint]
        self._doubt_until = self._now + self._doubt
        if since <= self._still:  # the same one, seen from the next frame
            return False
        self._jump_at[joint] = self._now
        return since <= self._second

    def _is_common(self, total: float, squares: list[float]) -> bool:
        """Return whether all channels changed alike, or all joints by as much.

        `total`: sum of all channels' changes (half ranges), `squares`: of each joint's, squared.
        """
        mean, square = abs(total) / self._count, sum(squares) / self._count
        if mean > LEAST_COMMON and mean * mean > COMMON * COMMON * square:
            return True
        each = [one / count for one, count in zip(squares, self._counts, strict=True)]
        least = min(each)
        return least > LEAST_EVEN * LEAST_EVEN and least > EVEN * EVEN * max(each)
