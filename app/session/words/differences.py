"""How one parameter set differs from another, in sentences with the words of the pages."""

import math
from collections.abc import Iterator

from app.calibration.vocabulary import Binding, DriveParameters, Gesture

DEGREES = 180.0 / math.pi

CONTROLS = {"u1+": "Faster", "u1-": "Slower", "u2+": "Turn left", "u2-": "Turn right", "stop": "Stop"}
U1_MODES = {"acceleration": "keeps its speed", "velocity": "follows the movement"}
U2_MODES = {"acceleration": "keeps turning", "velocity": "follows the movement"}
FEATURES = {"rate": "moving", "displacement": "holding"}
UNITS = {"rate": "FS/s", "displacement": "FS"}
SPEEDS = {  # name: words, unit, how many of it make one SI unit, digits
    "forward": ("Forward speed", "m/s", 1.0, 2),
    "reverse": ("Reverse speed", "m/s", 1.0, 2),
    "turn": ("Turn speed", "°/s", DEGREES, 0),
    "acceleration": ("Acceleration", "m/s²", 1.0, 1),
    "deceleration": ("Deceleration", "m/s²", 1.0, 1),
    "turn_acceleration": ("Turn acceleration", "°/s²", DEGREES, 0),
    "jerk": ("Softness", "m/s³", 1.0, 1),
    "turn_jerk": ("Turn softness", "°/s³", DEGREES, 0),
}
MOST_DIGITS = 9


def differences(now: DriveParameters, before: DriveParameters) -> list[str]:
    """Return what has changed since `before`, a sentence each; empty exactly when both sets are equal."""
    found = [*_heads(now, before), *_speeds(now, before), *_bindings(now, before), *_gestures(now, before)]
    if not found and now != before:
        found.append("The same movements and numbers, noted in another order.")
    return found


def _heads(now: DriveParameters, before: DriveParameters) -> Iterator[str]:
    if now.title != before.title:
        yield f"The set's name: “{before.title}” → “{now.title}”."
    if now.profile != before.profile:
        yield "The calibration is another one."
    if now.mode_u1 != before.mode_u1:
        yield f"Forward and back: {U1_MODES[before.mode_u1]} → {U1_MODES[now.mode_u1]}."
    if now.mode_u2 != before.mode_u2:
        yield f"Turning: {U2_MODES[before.mode_u2]} → {U2_MODES[now.mode_u2]}."
    if now.cutoff != before.cutoff:
        yield _change("Tremor damping", before.cutoff, now.cutoff, 1, "Hz")
    if now.cruise_time != before.cruise_time:
        yield _change("Stops by itself after", before.cruise_time, now.cruise_time, 0, "s")
    if now.turn_cruise_time != before.turn_cruise_time:
        yield _turn_time_out(now.turn_cruise_time, before.turn_cruise_time)


def _speeds(now: DriveParameters, before: DriveParameters) -> Iterator[str]:
    for name, (words, unit, factor, digits) in SPEEDS.items():
        old, new = getattr(before.speeds, name), getattr(now.speeds, name)
        if old != new:
            yield _change(words, old * factor, new * factor, digits, unit)


def _bindings(now: DriveParameters, before: DriveParameters) -> Iterator[str]:
    for control, words in CONTROLS.items():
        new, old = _bound(now, control), _bound(before, control)
        if new == old:
            continue
        said = _bound_words(before, old), _bound_words(now, new)
        yield f"{words}: {said[0]} → {said[1]}."


def _bound(parameters: DriveParameters, control: str) -> list[Binding]:
    return [binding for binding in parameters.bindings if binding.control == control]


def _bound_words(parameters: DriveParameters, bindings: list[Binding]) -> str:
    names = {gesture.name: _label(parameters, gesture) for gesture in parameters.gestures}
    parts = []
    for binding in bindings:
        together = " + " if binding.control == "stop" else " or "
        parts.append(f"{together.join(names[name] for name in binding.gestures) or 'nothing'}, gain {binding.gain:g}")
    return "; ".join(parts) or "nothing"


def _gestures(now: DriveParameters, before: DriveParameters) -> Iterator[str]:
    old_ones = {gesture.name: gesture for gesture in before.gestures}
    new_ones = {gesture.name: gesture for gesture in now.gestures}
    for name, new in new_ones.items():
        if name in old_ones:
            yield from _gesture(_label(now, new), new, old_ones[name])
        else:
            yield f"{_label(now, new)}: is a new movement."
    for name, old in old_ones.items():
        if name not in new_ones:
            yield f"{_label(before, old)}: is no movement any more."


def _gesture(label: str, new: Gesture, old: Gesture) -> Iterator[str]:
    if new.joint != old.joint:
        yield f"{label}: is read from another joint."
    if new.direction != old.direction:
        yield f"{label}: counts in the other direction."
    if new.feature != old.feature:
        yield f"{label}: {FEATURES[old.feature]} → {FEATURES[new.feature]}."
    unit = UNITS[new.feature]
    if new.dead_zone != old.dead_zone:
        yield _change(f"{label} counts from", old.dead_zone, new.dead_zone, 2, unit)
    if new.full != old.full:
        yield _change(f"{label} is full", old.full, new.full, 2, unit)


def _label(parameters: DriveParameters, gesture: Gesture) -> str:
    labels = {joint.name: joint.label for joint in parameters.profile.layout.joints}
    words = labels.get(gesture.joint, gesture.joint)
    return words if gesture.direction == 1 else f"{words}, going back"


def _turn_time_out(now: float | None, before: float | None) -> str:
    words = "Stops turning by itself after"
    if now is None or before is None:
        old, new = ("no time-out" if time is None else f"{time:g} s" for time in (before, now))
        return f"{words}: {old} → {new}."
    return _change(words, before, now, 1, "s")


def _change(words: str, before: float, now: float, digits: int, unit: str) -> str:
    """Return a change with as many digits as it takes to see it."""
    while digits < MOST_DIGITS and f"{before:.{digits}f}" == f"{now:.{digits}f}":
        digits += 1
    return f"{words}: {before:.{digits}f} → {now:.{digits}f} {unit}."
