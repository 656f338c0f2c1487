"""How one parameter set differs from another; the pages put it into words."""

from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Field

from app.calibration.vocabulary import Binding, Control, DriveParameters, Feature, Gesture
from app.quantities import Document
from app.speed_limits import Speeds

CONTROLS: tuple[Control, ...] = ("u1+", "u1-", "u2+", "u2-", "stop")
FIELDS = ("title", "profile", "mode_u1", "mode_u2", "cutoff", "cruise_time", "turn_cruise_time")
GESTURE_FIELDS = ("joint", "direction", "feature", "dead_zone", "full")

Value = str | float | None


class FieldDifference(Document):
    """Another value of a field, in SI units; without values for `profile`, and for `order`: only the order differs."""

    kind: Literal["field"] = "field"
    name: str  # a field of the set or of its speeds, or `order`
    before: Value = None
    now: Value = None


class NamedGesture(Document):
    """A gesture as people know it: the label of its joint, and its direction."""

    joint: str
    direction: Literal[1, -1]


class BoundGestures(Document):
    """The gestures of one binding, with its gain."""

    gestures: tuple[NamedGesture, ...]
    gain: float


class BindingDifference(Document):
    """Other bindings of one control."""

    kind: Literal["binding"] = "binding"
    control: Control
    before: tuple[BoundGestures, ...]
    now: tuple[BoundGestures, ...]


class GestureDifference(Document):
    """Another value of a gesture's field, or, without values, a gesture that was added or removed."""

    kind: Literal["gesture"] = "gesture"
    gesture: NamedGesture
    feature: Feature
    name: Literal["added", "removed", "joint", "direction", "feature", "dead_zone", "full"]
    before: Value = None
    now: Value = None


Difference = Annotated[FieldDifference | BindingDifference | GestureDifference, Field(discriminator="kind")]


def differences(now: DriveParameters, before: DriveParameters) -> list[Difference]:
    """Return the differences of `now` from `before`; none exactly when both sets are equal."""
    all_differences = [*_fields(now, before), *_bindings(now, before), *_gestures(now, before)]
    if not all_differences and now != before:
        all_differences.append(FieldDifference(name="order"))
    return all_differences


def _fields(now: DriveParameters, before: DriveParameters) -> Iterator[Difference]:
    pairs = [(name, getattr(before, name), getattr(now, name)) for name in FIELDS]
    pairs += [(name, getattr(before.speeds, name), getattr(now.speeds, name)) for name in Speeds.model_fields]
    for name, old, new in pairs:
        if name == "profile" and new != old:
            yield FieldDifference(name=name)
        elif new != old:
            yield FieldDifference(name=name, before=old, now=new)


def _bindings(now: DriveParameters, before: DriveParameters) -> Iterator[Difference]:
    for control in CONTROLS:
        new, old = _bindings_of(now, control), _bindings_of(before, control)
        if new != old:
            yield BindingDifference(control=control, before=_bound(before, old), now=_bound(now, new))


def _bindings_of(parameters: DriveParameters, control: Control) -> list[Binding]:
    return [binding for binding in parameters.bindings if binding.control == control]


def _bound(parameters: DriveParameters, bindings: list[Binding]) -> tuple[BoundGestures, ...]:
    named = {gesture.name: _named(parameters, gesture) for gesture in parameters.gestures}
    return tuple(
        BoundGestures(gestures=tuple(named[name] for name in binding.gestures), gain=binding.gain)
        for binding in bindings
    )


def _gestures(now: DriveParameters, before: DriveParameters) -> Iterator[Difference]:
    old_ones = {gesture.name: gesture for gesture in before.gestures}
    new_ones = {gesture.name: gesture for gesture in now.gestures}
    for name, new in new_ones.items():
        old = old_ones.get(name)
        if old is None:
            yield GestureDifference(gesture=_named(now, new), feature=new.feature, name="added")
            continue
        for field in GESTURE_FIELDS:
            values = getattr(old, field), getattr(new, field)
            if values[0] != values[1]:
                yield GestureDifference(
                    gesture=_named(now, new), feature=new.feature, name=field, before=values[0], now=values[1]
                )
    for name, old in old_ones.items():
        if name not in new_ones:
            yield GestureDifference(gesture=_named(before, old), feature=old.feature, name="removed")


def _named(parameters: DriveParameters, gesture: Gesture) -> NamedGesture:
    labels = parameters.profile.layout.joint_labels
    return NamedGesture(joint=labels.get(gesture.joint, gesture.joint), direction=gesture.direction)
