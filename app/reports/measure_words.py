"""The words of the measures on a report, and which lead; equal to those on the pages (texts/en/measures.js)."""

import math
from collections.abc import Mapping
from typing import Any, Final

from app.scoring.learning_words import MEASURES
from app.scoring.verdict.measure_verdict import Verdict

# In the order of the pages.
MEASURE_WORDS: Final[dict[str, str]] = {
    "stages_done": "Stages done",
    "follow_error_rms": "Usual error of the distance to the leader",
    "follow_error_max": "Largest error of the distance to the leader",
    "follow_near": "Share of time near the asked distance",
    "heading_error_deg": "Angle off the mark",
    "turn_drift": "Moved off the spot",
    "cones_touched": "Cones touched",
    "gap_clearance": "Narrowest clearance in a gap",
    "door_contacts": "Contacts with door or gap",
    "e_diff": "Area off the path",
    "dist": "Distance driven",
    "time": "Time",
    "dist_ratio": "Distance over path length",
    "cross_track_rms": "Usual distance from the path",
    "cross_track_max": "Largest distance from the path",
    "mean_speed": "Mean speed",
    "stops": "Stops",
    "collisions": "Contacts",
    "contact_time": "Time in contact",
    "turn_reversals": "Changes of turning",
    "pulses_per_metre": "Commands per metre",
    "sparc": "Smoothness",
    "ldlj": "Smoothness, another measure",
}

# What leads, by what a trial has: the first whose named measures are all there. The pages lead with the same.
LEADING: Final[tuple[tuple[tuple[str, ...], tuple[str, ...]], ...]] = (
    (("stages_done",), ("stages_done", "time", "collisions")),
    (("heading_error_deg",), ("heading_error_deg", "turn_drift", "time")),
    (("follow_error_rms",), ("follow_error_rms", "follow_near", "e_diff")),
    (("gaps", "gap_clearance"), ("gap_clearance", "e_diff", "time")),
    (("cones_touched",), ("cones_touched", "e_diff", "time")),
    ((), ("e_diff", "dist", "time")),
)
_FURTHER: Final = ("sparc", "collisions")  # beside those that lead, as far as there are four
MOST_MEASURES: Final = 4


def leading_measures(measures: Mapping[str, Any]) -> list[str]:
    """Return the three or four measures that say most about a task, by what a trial of it has."""
    names = next(large for has, large in LEADING if all(measures.get(name) is not None for name in has))
    return [name for name in (*dict.fromkeys((*names, *_FURTHER)),) if measures.get(name) is not None][:MOST_MEASURES]


def with_unit(name: str, value: float | None) -> str:
    """Return a level of a measure in words; "" for None."""
    return "" if value is None or not math.isfinite(value) else MEASURES[name].level(value)


def noise_words(name: str, verdict: Verdict) -> str:
    """Return from where to where a level is within noise; "" for too few trials."""
    if verdict.low is None or verdict.high is None:
        return ""
    measure = MEASURES[name]
    return measure.with_unit(f"{measure.figure(verdict.low)} to {measure.figure(verdict.high)}")
