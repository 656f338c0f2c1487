"""Whether the person can still stop what moves now (safety S5 and S22)."""

from collections.abc import Sequence
from typing import NamedTuple

from app.calibration.vocabulary import DriveParameters
from app.geometry import STANDSTILL, Twist


class _Axis(NamedTuple):
    """One axis of the twist that keeps its speed while nobody makes a gesture."""

    raises: tuple[int, ...]  # indices of the gestures that drive towards positive speed
    lowers: tuple[int, ...]  # towards negative speed

    def can_stop(self, speed: float, bad: Sequence[bool]) -> bool:
        """Return whether a believable gesture slows `speed`, and at rest, whatever believable gestures can begin."""
        raises = any(not bad[i] for i in self.raises)
        lowers = any(not bad[i] for i in self.lowers)
        if speed > 0.0:
            return lowers
        if speed < 0.0:
            return raises
        return raises == lowers


class Brakes:
    """The gestures of a parameter set that can bring the chair to rest.

    An axis in velocity mode needs none of them: it slows down by itself as soon as the person rests, or as soon as its
    gestures cannot be believed. An axis in acceleration mode keeps its speed. It needs a gesture against the direction
    in which it moves, or a stop gesture whose parts are all believable. A time-out is no substitute for either.
    """

    def __init__(self, parameters: DriveParameters) -> None:
        self._forward = _axis(parameters, "u1") if parameters.mode_u1 == "acceleration" else None
        self._turn = _axis(parameters, "u2") if parameters.mode_u2 == "acceleration" else None
        self._stops = _possible_stops(parameters)
        self._all_bad = [True] * len(parameters.gestures)
        self.are_complete = self.suffice(STANDSTILL, [False] * len(parameters.gestures))
        """Whether the person can stop every motion as long as all gestures are believable."""

    def suffice(self, twist: Twist, bad: Sequence[bool]) -> bool:
        """Return whether the person can bring `twist` to rest, given which gestures are not believable.

        Of a chair that stands, it is whether the person can stop every motion that a believable gesture can begin.
        """
        if any(not any(bad[i] for i in stop) for stop in self._stops):
            return True
        stands = twist == STANDSTILL
        for axis, speed in ((self._forward, twist.v), (self._turn, twist.omega)):
            if axis and (speed or stands) and not axis.can_stop(speed, bad):
                return False
        return True

    def are_needed(self, twist: Twist) -> bool:
        """Return whether `twist` goes on while no gesture is believable."""
        return not self.suffice(twist, self._all_bad)


def missing_brake(parameters: DriveParameters) -> str:
    """Return in a sentence that a set has motions which nobody could stop, and what to do; empty when it has none."""
    if Brakes(parameters).are_complete:
        return ""
    return (
        "With these controls the chair would keep a speed that no movement can slow: on the Controls page, bind a "
        "movement to the opposite direction or to Stop, or choose “Follows the movement”."
    )


def _axis(parameters: DriveParameters, name: str) -> _Axis:
    """Return the gestures that change the speed of the axis `name`, "u1" or "u2".

    Only the sum of a gesture's gains counts: a gesture bound to both directions with equal gains changes nothing.
    """
    gains = [0.0] * len(parameters.gestures)
    places = {gesture.name: i for i, gesture in enumerate(parameters.gestures)}
    for binding in parameters.bindings:
        for gesture in binding.gestures if binding.control.startswith(name) else ():
            gains[places[gesture]] += binding.gain if binding.control.endswith("+") else -binding.gain
    return _Axis(
        raises=tuple(i for i, gain in enumerate(gains) if gain > 0.0),
        lowers=tuple(i for i, gain in enumerate(gains) if gain < 0.0),
    )


def _possible_stops(parameters: DriveParameters) -> list[list[int]]:
    """Return the gestures of each stop, without the stops that ask one joint for both directions at once."""
    places = {gesture.name: i for i, gesture in enumerate(parameters.gestures)}
    stops = [[places[name] for name in one.gestures] for one in parameters.bindings if one.control == "stop"]
    return [stop for stop in stops if stop and _can_be_together(parameters, stop)]


def _can_be_together(parameters: DriveParameters, indices: Sequence[int]) -> bool:
    gestures = [parameters.gestures[i] for i in indices]
    directions = {(gesture.joint, gesture.feature): gesture.direction for gesture in gestures}
    return all(directions[gesture.joint, gesture.feature] == gesture.direction for gesture in gestures)
