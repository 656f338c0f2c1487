"""A model of piezoresistive fabric, from postures to channel voltages; without a clock, for the loop and the study.

The shapes and sizes were measured on a real piezoresistive knit of 20 wearers: a slightly curved response,
creep with two time constants, a hysteresis loop, drift, noise, steps of the converter, and other gains and offsets each
time the shirt is put on.
"""

# Compiled in a wheel (hatch_build.py).

import math
from collections.abc import Callable, Collection
from dataclasses import dataclass
from itertools import accumulate, repeat

import numpy as np
from numpy.typing import NDArray

from app.hardware.body.joints import degrees_of_freedom, second_way
from app.layout import ShirtLayout
from app.texts import Text

FULL_SCALE = 3.3  # V, of the converter
STEPS = 4096  # of the converter: 12 bits
SPAN = 0.45  # V by which a channel of strength 1 changes over the full movement of its joint
REST_LEVEL = (1.2, 1.8)  # V at rest: the middle of the converter's range, with room in both directions
STRENGTH = (0.5, 1.0)  # of SPAN: how strongly a channel responds to its joint
SLACKENING = 0.3  # share of channels that slacken where the others stretch
# Arrays without dimensions: numpy takes half as long with them as with Python's numbers.
STEPS_PER_VOLT, VOLTS_PER_STEP = np.array(STEPS / FULL_SCALE), np.array(FULL_SCALE / STEPS)
FLOAT32 = np.dtype(np.float32)
LOWEST, HIGHEST = np.array(0.0), np.array(STEPS - 1.0)
BLOCK = 256  # frames of noise, and of drift, computed at once
BODIES = (0.7, 1.4)  # response of a channel on another person, relative to the first wearer
TURN_DEG = (8.0, 17.0)  # angle by which a joint's main direction turns when the shirt is put on again


@dataclass(frozen=True, slots=True)
class FabricProperties:
    """Properties of the fabric; shares are of a channel's own response to a full movement."""

    quadratic: float = 0.15
    creep_fast: float = 0.10  # with time constant `fast`
    creep_slow: float = 0.30  # with time constant `slow`
    fast: float = 1.5  # s
    slow: float = 50.0  # s
    loop: float = 0.10  # height of the hysteresis loop
    loop_length: float = 0.15  # share of the full movement over which the hysteresis reverses
    peak: float = 0.0  # response to speed, per (full movement / s) ** peak_power; 0: none
    peak_power: float = 0.8
    drift_per_minute: float = 0.03  # median over channels
    drift_spread: float = 1.08  # of the logarithm: one channel in ten drifts four times as fast
    drift_period: float = 120.0  # s, period of a channel's drift; a longer one would leave the range of S5
    noise: float = 0.006
    second_way: float = 0.44  # response of a joint's channels to its second degree of freedom, relative to the first
    neighbour: float = 0.10  # response to the other joints of the same side
    stranger: float = 0.02  # response to the joints of the other side


PEAKY = FabricProperties(peak=0.06)
"""A fabric that also responds to the speed of a movement."""

STANDARD = FabricProperties()


class _Rows:
    """Rows that are computed in blocks (n, n_channels) and read one by one."""

    __slots__ = ("_at", "_block", "_compute")

    def __init__(self, compute: Callable[[], NDArray[np.float64]]) -> None:
        self._compute = compute
        self._block = np.empty((0, 0))
        self._at = 0

    def next_row(self) -> NDArray[np.float64]:
        """Return the next row (n_channels,)."""
        if self._at == len(self._block):
            self._block, self._at = self._compute(), 0
        row: NDArray[np.float64] = self._block[self._at]
        self._at += 1
        return row


class Fabric:
    """The channels of one shirt: from a posture (n_joints,) to values (n_channels,) in V."""

    def __init__(
        self,
        layout: ShirtLayout,
        seed: int,
        dead_channels: Collection[str] = (),
        properties: FabricProperties = STANDARD,
    ) -> None:
        """Draw the shirt's properties; the seed determines the shirt and its noise.

        Raises
        ------
        ValueError
            When a dead channel is not in the layout.
        """
        for name in dead_channels:
            if name not in layout.channel_names:
                raise ValueError(Text("shirtdev-no-channel", shirt=layout.name, channel=name))
        self.layout = layout
        self.joints = degrees_of_freedom(layout.joint_names)
        self._properties = properties
        self._random = np.random.default_rng(seed)
        channels, ways = len(layout.channels), len(self.joints)
        rng = self._random
        self.gains = _gains(layout, self.joints, properties, rng)
        self._strength = np.abs(self.gains).max(axis=1) * SPAN  # V
        self._offsets = rng.uniform(*REST_LEVEL, channels)
        self._first = (
            self.gains,
            self._offsets,
        )  # each time the shirt is put on, its values lie near these
        self._shares = _shares(channels, properties, rng)
        self._dead = np.array(
            [i for i, name in enumerate(layout.channel_names) if name in dead_channels], dtype=np.intp
        )
        # A broken line reads the end of the converter's range, a stuck line any constant value.
        self._dead_values = np.where(rng.random(len(self._dead)) < 0.5, 0.0, rng.uniform(0.5, 2.8, len(self._dead)))
        median_rate = 2 * math.pi / properties.drift_period / math.sqrt(2.0)  # of a sine of amplitude 1, roughly
        amplitude = properties.drift_per_minute / 60.0 / median_rate
        self._drift_size = self._strength * amplitude * np.exp(rng.normal(0.0, properties.drift_spread, channels))
        self._drift_speed = 2 * math.pi / (properties.drift_period * rng.uniform(0.7, 1.4, channels))
        self._drift_phase = rng.uniform(0.0, 2 * math.pi, channels)
        parts = np.zeros((6, ways))
        self._movement = parts.ravel()  # what the channels respond to: all parts, one after the other
        self._before, self._square, self._averages = parts[0], parts[1], parts[2:4]
        self._loop, self._speed = parts[4], parts[5]
        self._reversal = np.full(ways, -1.0 / properties.loop_length)
        self._noise = _Rows(self._noise_block)
        self._compute_matrix()
        self.reset()

    def reset(self) -> None:
        """Reset the fabric to a long rest: no creep, no hysteresis."""
        self._movement[:] = 0.0
        self._t = 0.0
        self._dt = math.nan  # s, of the last step

    def worn_by(self, wearer: int) -> None:
        """Let another person wear the shirt; `wearer` is the seed of this person's body and of the noise.

        Each channel responds 0.7 to 1.4 times as strongly as on the first wearer, and the shirt sits as after
        `don_again`.
        """
        self._random = np.random.default_rng(wearer)
        gains, offsets = self._first
        self._first = gains * self._random.uniform(*BODIES, len(gains))[:, np.newaxis], offsets
        self.don_again()

    def don_again(self) -> None:
        """Take the shirt off and put it on again: other gains and offsets, and every joint's direction turned.

        The changes are relative to the first values and do not add up over several times.
        """
        rng = self._random
        first_gains, offsets = self._first
        gains = first_gains * rng.uniform(0.8, 1.2, len(first_gains))[:, np.newaxis]
        for joint, channels in self.layout.channels_of_joint.items():
            if len(channels) > 1:
                column = self.joints.index(joint)
                angle = math.radians(rng.uniform(*TURN_DEG))
                gains[channels, column] = _turned(first_gains[channels, column], gains[channels, column], angle, rng)
        self.gains = gains
        standard_deviation = 0.3 * self._strength  # V, of a channel while its joint moves freely
        self._offsets = offsets + standard_deviation * rng.uniform(-2.0, 2.0, len(gains))
        self._compute_matrix()
        self.reset()

    def step(self, posture: NDArray[np.float64], dt: float) -> NDArray[np.float32]:
        """Return the channels (n_channels,) in V, `dt` (s) after the step before, at `posture` (n_joints,)."""
        if dt != self._dt:
            self._set_step(dt)
        before, square, loop, speed = self._before, self._square, self._loop, self._speed
        moved = posture - before
        before[:] = posture
        np.multiply(posture, posture, out=square)
        apart = posture - self._averages
        apart *= self._keep
        self._averages += apart
        # Duhem's hysteresis: after a reversal it changes sign within `loop_length`, at any speed.
        side = np.sign(moved)
        np.abs(moved, out=moved)
        loop -= side
        loop *= np.exp(moved * self._reversal)
        loop += side
        if self._properties.peak:
            np.power(moved / dt, self._properties.peak_power, out=speed)
        values: NDArray[np.float64] = self._matrix.dot(self._movement)  # `@` takes twice as long
        values += self._drift.next_row()
        values += self._noise.next_row()
        values += self._offsets
        self._t += dt
        values *= STEPS_PER_VOLT
        np.rint(values, out=values)
        np.maximum(values, LOWEST, out=values)  # np.clip takes four times as long
        np.minimum(values, HIGHEST, out=values)
        values *= VOLTS_PER_STEP
        if len(self._dead):
            values[self._dead] = self._dead_values
        return values.astype(FLOAT32)

    def _set_step(self, dt: float) -> None:
        self._dt = dt
        keep = [1.0 - math.exp(-dt / time) for time in (self._properties.fast, self._properties.slow)]
        self._keep = np.repeat(np.array(keep)[:, np.newaxis], len(self.joints), axis=1)
        self._drift = _Rows(self._drift_block)

    def _compute_matrix(self) -> None:
        """Compute the matrix (n_channels, 6 n_joints) from all parts of the movement to volts."""
        self._matrix = np.concatenate([self.gains * share[:, np.newaxis] for share in self._shares], axis=1) * SPAN

    def _noise_block(self) -> NDArray[np.float64]:
        """Return the noise of the next frames (BLOCK, n_channels), V."""
        drawn: NDArray[np.float64] = self._random.standard_normal((BLOCK, len(self._offsets)))
        drawn *= self._properties.noise * self._strength
        return drawn

    def _drift_block(self) -> NDArray[np.float64]:
        """Return the drift of the next frames (BLOCK, n_channels), V."""
        times = list(accumulate(repeat(self._dt, BLOCK), initial=self._t))[1:]
        turns = np.multiply.outer(times, self._drift_speed) + self._drift_phase
        return np.asarray(self._drift_size * np.sin(turns))


def _gains(
    layout: ShirtLayout, ways: tuple[str, ...], properties: FabricProperties, rng: np.random.Generator
) -> NDArray[np.float64]:
    """Return the response of each channel to each degree of freedom (n_channels, n_joints)."""
    gains = np.empty((len(layout.channels), len(ways)))
    for i, channel in enumerate(layout.channels):
        side = channel.joint.partition("_")[0]
        for j, way in enumerate(ways):
            if way == channel.joint:
                gains[i, j] = rng.uniform(*STRENGTH) * (-1.0 if rng.random() < SLACKENING else 1.0)
            elif way == second_way(channel.joint):
                gains[i, j] = rng.uniform(-1.0, 1.0)
            else:
                reach = properties.neighbour if way.partition("_")[0] == side else properties.stranger
                gains[i, j] = rng.uniform(-1.0, 1.0) * reach
    for joint, channels in layout.channels_of_joint.items():
        second = second_way(joint)
        if second is not None:
            first, aside = gains[channels, ways.index(joint)], gains[channels, ways.index(second)]
            gains[channels, ways.index(second)] = _set_apart(first, aside, properties.second_way)
    return gains


def _set_apart(first: NDArray[np.float64], aside: NDArray[np.float64], ratio: float) -> NDArray[np.float64]:
    """Return `aside` less 70 % of its component along `first`, scaled to `ratio` times the length of `first`."""
    ahead = first / np.linalg.norm(first)
    apart = aside - 0.7 * (aside @ ahead) * ahead
    scaled: NDArray[np.float64] = apart * (ratio * np.linalg.norm(first) / np.linalg.norm(apart))
    return scaled


def _shares(channels: int, properties: FabricProperties, rng: np.random.Generator) -> list[NDArray[np.float64]]:
    """Return for each part of the movement the share that each channel shows (n_channels,)."""
    p = properties

    def _around(share: float) -> NDArray[np.float64]:
        return share * rng.uniform(0.6, 1.4, channels)

    return [
        np.ones(channels),
        _around(p.quadratic),
        _around(p.creep_fast),
        _around(p.creep_slow),
        -_around(p.loop / 2),
        _around(p.peak),
    ]


def _turned(
    before: NDArray[np.float64], after: NDArray[np.float64], angle: float, rng: np.random.Generator
) -> NDArray[np.float64]:
    """Return a vector as long as `after`, turned from `before` by `angle` (rad) towards `after`."""
    ahead = before / np.linalg.norm(before)
    aside = after - (after @ ahead) * ahead
    if np.linalg.norm(aside) < 1e-9:
        aside = rng.normal(size=len(before))
        aside -= (aside @ ahead) * ahead
    aside /= np.linalg.norm(aside)
    turned: NDArray[np.float64] = np.linalg.norm(after) * (math.cos(angle) * ahead + math.sin(angle) * aside)
    return turned
