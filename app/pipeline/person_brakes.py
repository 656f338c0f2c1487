"""Whether the person can still stop the motion of the chair (safety S5 and S22)."""

# Compiled in a wheel (hatch_build.py).

import itertools
from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

from app.calibration.vocabulary import DriveParameters, Feature, Gesture
from app.geometry import STANDSTILL, Twist
from app.texts import Text

STOP_ACTIVATION: Final = 0.5  # of each gesture of a stop: well above the cross-talk of other movements
LEAST_BRAKE = 0.1  # gain: a gesture with a smaller gain slows the chair too late to count as a brake
REACH: dict[Feature, float] = {
    "rate": 10.0,  # FS/s: the whole movement within about a fifth of a second, with a smooth beginning and end
    "displacement": 1.0,  # FS: the whole movement
}


class _Push(NamedTuple):
    """The effect of a movement on the speed of an axis: the lowest and the highest sum of gains that it can reach.

    Several gestures can read one movement, each from its own dead-zone on. Nobody can make one of them without the
    others.
    """

    low: float = 0.0
    high: float = 0.0

    def along(self, sign: int) -> bool:
        """Return whether the movement can change the speed towards `sign`, 1 or -1; False for 0."""
        return self.high > 0.0 if sign > 0 else sign < 0 and self.low < 0.0

    def strength(self, sign: int) -> float:
        """Return the largest sum of gains towards `sign`, 1 or -1."""
        return self.high if sign > 0 else -self.low

    def brakes(self, sign: int) -> bool:
        """Return whether the movement slows a speed of this sign and never raises it."""
        return self.strength(-sign) >= LEAST_BRAKE and not self.along(sign)


_Signs = tuple[int, int]
"""The direction of motion of each axis that keeps its speed: 1, -1, or 0."""


class Brakes:
    """The gestures of a parameter set that can bring the chair to rest.

    An axis in velocity mode needs no brake: it slows down by itself as soon as the person rests, or as soon as the
    channels of its gestures are bad. An axis in acceleration mode keeps its speed. To stop, it needs a gesture against
    its direction of motion that does not drive the other axis further, or a stop gesture, with good channels. A
    time-out replaces neither.
    """

    def __init__(self, parameters: DriveParameters) -> None:
        self._keeps = parameters.mode_u1 == "acceleration", parameters.mode_u2 == "acceleration"
        self._pushes = _both_pushes(parameters)
        self._within_reach = [_is_within_reach(gesture) for gesture in parameters.gestures]
        self._stops = _possible_stops(parameters)
        self._all_bad = [True] * len(parameters.gestures)
        self.are_complete = self.suffice(STANDSTILL, [False] * len(parameters.gestures))
        """Whether the person can stop every motion as long as no gesture has bad channels."""

    def suffice(self, twist: Twist, bad: Sequence[bool]) -> bool:
        """Return whether the person can bring `twist` to rest, given which gestures have bad channels.

        For a chair that stands: whether the person can stop every motion that a gesture with good channels can begin.
        """
        if any(not any(bad[i] for i in stop) for stop in self._stops):
            return True
        believable = [i for i, is_bad in enumerate(bad) if not is_bad]
        brakes = [self._pushes[i] for i in believable if self._within_reach[i]]
        if twist == STANDSTILL:
            begun = self._can_begin([self._pushes[i] for i in believable])
            return all(_can_stop(signs, brakes) for signs in begun)
        return _can_stop((self._sign(0, twist.v), self._sign(1, twist.omega)), brakes)

    def are_needed(self, twist: Twist) -> bool:
        """Return whether `twist` continues while every gesture has bad channels."""
        return not self.suffice(twist, self._all_bad)

    def _sign(self, axis: int, speed: float) -> int:
        return ((speed > 0.0) - (speed < 0.0)) if self._keeps[axis] else 0

    def _can_begin(self, believable: Sequence[tuple[_Push, _Push]]) -> Iterator[_Signs]:
        """Yield each pair of directions in which the axes can be set in motion."""
        directions = [
            [
                sign
                for sign in (-1, 0, 1)
                if not sign or any(push[axis].along(self._sign(axis, sign)) for push in believable)
            ]
            for axis in (0, 1)
        ]
        yield from itertools.product(*directions)


def missing_brake(parameters: DriveParameters) -> Text | None:
    """Return a sentence when the parameters allow motions that nobody could stop; None when they do not."""
    if not Brakes(parameters).are_complete:
        return Text("drives-speed-without-brake")
    if not all(_stops_although_stuck(parameters, i) for i in parameters.bound_gestures):
        return Text("drives-posture-without-brake")
    return None


def _stops_although_stuck(parameters: DriveParameters, index: int) -> bool:
    """Return whether the person can stop the chair while the sensors of a gesture's joint are stuck at any value.

    The noise of a stuck sensor can be that of a good one, so that nothing else would stop a held posture that drives.
    A stop gesture that the stuck gesture is part of works only from STOP_ACTIVATION on: below it, another movement must
    outweigh what the stuck gesture can still do.
    """
    gesture = parameters.gestures[index]
    pushes = _both_pushes(parameters)
    if gesture.feature == "rate" or pushes[index] == (_Push(), _Push()):
        return True  # a stuck joint makes no movement, and what drives nothing may stay
    others = [i for i, other in enumerate(parameters.gestures) if other.joint != gesture.joint]
    stops = [stop for stop in _possible_stops(parameters) if set(stop) <= {index, *others}]
    if any(index not in stop for stop in stops):
        return True
    brakes = [pushes[i] for i in others if _is_within_reach(parameters.gestures[i])]
    return any(len(stop) > 1 for stop in stops) and all(
        _outweighs(axis, pushes[index][axis], brakes) for axis in (0, 1)
    )


def _outweighs(axis: int, push: _Push, brakes: Sequence[tuple[_Push, _Push]]) -> bool:
    """Return whether brakes that drive nothing else are stronger than STOP_ACTIVATION of a push, both ways."""
    return all(
        not push.along(sign)
        or any(
            brake[axis].strength(-sign) > STOP_ACTIVATION * push.strength(sign)
            and brake[axis].brakes(sign)
            and brake[1 - axis] == _Push()
            for brake in brakes
        )
        for sign in (1, -1)
    )


def _is_within_reach(gesture: Gesture) -> bool:
    """Return whether a body can make half of a gesture, which a stop requires."""
    return (gesture.dead_zone + gesture.full) / 2.0 <= REACH[gesture.feature]


def _can_stop(signs: _Signs, brakes: Sequence[tuple[_Push, _Push]]) -> bool:
    """Return whether each axis in motion has a brake that does not drive the other axis further."""
    return all(
        not signs[axis]
        or any(push[axis].brakes(signs[axis]) and not push[1 - axis].along(signs[1 - axis]) for push in brakes)
        for axis in (0, 1)
    )


def _pushes(parameters: DriveParameters, name: str) -> list[_Push]:
    """Return the effect of each gesture's movement on the axis `name`, "u1" or "u2".

    Only the sum of a gesture's gains counts: a gesture bound to both directions with equal gains changes nothing.
    """
    gains = [0.0] * len(parameters.gestures)
    places = {gesture.name: i for i, gesture in enumerate(parameters.gestures)}
    for binding in parameters.bindings:
        for gesture in binding.gestures if binding.control.startswith(name) else ():
            gains[places[gesture]] += binding.gain if binding.control.endswith("+") else -binding.gain
    movements = [(gesture.joint, gesture.feature, gesture.direction) for gesture in parameters.gestures]
    reached = [
        [gain for gain, other in zip(gains, movements, strict=True) if other == movement] for movement in movements
    ]
    return [_Push(min(0.0, *those), max(0.0, *those)) for those in reached]


def _both_pushes(parameters: DriveParameters) -> list[tuple[_Push, _Push]]:
    """Return the effect of each gesture's movement on u1 and on u2."""
    return list(zip(_pushes(parameters, "u1"), _pushes(parameters, "u2"), strict=True))


def _possible_stops(parameters: DriveParameters) -> list[list[int]]:
    """Return the indices of the gestures of each stop, without the stops that no body can make."""
    places = {gesture.name: i for i, gesture in enumerate(parameters.gestures)}
    stops = [
        [places[name] for name in binding.gestures] for binding in parameters.bindings if binding.control == "stop"
    ]
    return [stop for stop in stops if stop and _can_be_together(parameters, stop)]


def _can_be_together(parameters: DriveParameters, indices: Sequence[int]) -> bool:
    """Return whether each gesture is within reach, and no two ask a joint for opposite movements."""
    gestures = [parameters.gestures[i] for i in indices]
    if not all(map(_is_within_reach, gestures)):
        return False
    directions = {(gesture.joint, gesture.feature): gesture.direction for gesture in gestures}
    return all(directions[gesture.joint, gesture.feature] == gesture.direction for gesture in gestures)
