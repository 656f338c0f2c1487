"""The condition of the trials in words: the map, what each movement does with its gains, modes and speeds."""

import math
from collections.abc import Mapping
from typing import Any, Final

from app.features.reports.document import NO_TABLE, Fact, ReportTable
from app.features.reports.material import ParameterMaterial

CONTROL_WORDS: Final = {
    "u1+": "Faster",
    "u1-": "Slower",
    "u2+": "Turn left",
    "u2-": "Turn right",
    "stop": "Stop",
}
MODE_WORDS: Final = {
    "mode_u1": {"acceleration": "keeps its speed", "velocity": "follows the movement"},
    "mode_u2": {"acceleration": "keeps turning", "velocity": "follows the movement"},
}
ORIGIN_WORDS: Final = {
    "calibration": "",
    "adaptation": ", adapted",
    "donning": ", fitted to how the shirt sat",
    "back": ", taken back",
}
METHOD_WORDS: Final = {"pca": "standard", "guided": "learnt from the cues", "prior": "learnt from other people"}
CONTROLS_HEAD: Final = ("Control", "Movement", "Counts from", "Full at", "Gain")


def condition_facts(parameters: ParameterMaterial) -> tuple[Fact, ...]:
    """Return the map, the modes and the speeds in words."""
    settings = parameters.settings
    maps = {joint.get("map", "pca") for joint in parameters.profile.get("joints", ())}
    origin = ORIGIN_WORDS.get(parameters.origin, parameters.origin)
    parent = "" if parameters.parent is None else f" from version {parameters.parent}"
    method = " and ".join(METHOD_WORDS[one] for one in METHOD_WORDS if one in maps) or METHOD_WORDS["pca"]
    of_body = {True: ", of a simulated shirt", False: "", None: ", source not recorded"}[parameters.simulated]
    modes = [MODE_WORDS[name].get(settings.get(name, ""), "not recorded") for name in MODE_WORDS]
    return (
        Fact("Calibration", f"Version {parameters.version}{origin}{parent}, {method}{of_body}"),
        Fact("How it drives", f"Forward and back: {modes[0]}. Turning: {modes[1]}"),
        Fact("Set", parameters.title),
        Fact("Stops by itself after", _stops(settings)),
        Fact("Speeds", _speeds(settings)),
        Fact("Tremor damping", _figure(settings, "cutoff", "Hz")),
    )


def controls_table(parameters: ParameterMaterial) -> ReportTable:
    """Return what each movement does, from where it counts, where it is full, and its gain."""
    gestures = {gesture["name"]: gesture for gesture in parameters.settings.get("gestures", ())}
    labels = _joint_labels(parameters.profile)
    rows = []
    for binding in parameters.settings.get("bindings", ()):
        control, named = binding["control"], [gestures[name] for name in binding["gestures"] if name in gestures]
        words = CONTROL_WORDS.get(control, control)
        if control == "stop":
            rows.append((words, " + ".join(_gesture_words(one, labels) for one in named), "", "", ""))
        else:
            gain = f"{binding.get('gain', 1.0):g}"
            rows += [
                (words, _gesture_words(one, labels), _share(one, "dead_zone"), _share(one, "full"), gain)
                for one in named
            ]
    return ReportTable(CONTROLS_HEAD, tuple(rows)) if rows else NO_TABLE


def _joint_labels(profile: Mapping[str, Any]) -> dict[str, str]:
    return {joint["name"]: joint["label"] for joint in profile.get("layout", {}).get("joints", ())}


def _gesture_words(gesture: Mapping[str, Any], labels: Mapping[str, str]) -> str:
    joint = labels.get(gesture["joint"], gesture["joint"])
    words = f"{joint}, going back" if gesture.get("direction", 1) < 0 else joint
    return f"{words}, held" if gesture.get("feature") == "displacement" else words


def _share(gesture: Mapping[str, Any], name: str) -> str:
    unit = "% / s" if gesture.get("feature", "rate") == "rate" else "%"
    return f"{100 * gesture[name]:.0f} {unit}".replace(" ", "\u00a0")


def _speeds(settings: Mapping[str, Any]) -> str:
    speeds = settings.get("speeds", {})
    if not {"forward", "reverse", "turn"} <= speeds.keys():
        return "not recorded"
    turn = math.degrees(speeds["turn"])
    return f"Forward {speeds['forward']:.2g}, back {speeds['reverse']:.2g} m/s, turning {turn:.0f} °/s"


def _stops(settings: Mapping[str, Any]) -> str:
    turning = settings.get("turn_cruise_time")
    return _figure(settings, "cruise_time", "s") + ("" if turning is None else f", turning {turning:g} s")


def _figure(settings: Mapping[str, Any], name: str, unit: str) -> str:
    value = settings.get(name)
    return "not recorded" if value is None else f"{value:g} {unit}"
