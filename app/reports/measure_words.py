"""The words of the measures on a report, and which lead; equal to those on the pages (texts/en/measures.js)."""

import math
from typing import Final

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

REACHED_WORDS: Final = "Goal reached"


def with_unit(name: str, value: float | None) -> str:
    """Return a level of a measure in words; "" for None."""
    return "" if value is None or not math.isfinite(value) else MEASURES[name].level(value)


def share_words(share: float | None) -> str:
    """Return a share in percent, in words; "" for None."""
    return "" if share is None else f"{100 * share:.0f} %"


def noise_words(name: str, verdict: Verdict) -> str:
    """Return from where to where a level is within noise; "" for too few trials, or no word."""
    if verdict.low is None or verdict.high is None:
        return ""
    measure = MEASURES[name]
    return measure.with_unit(f"{measure.figure(verdict.low)} to {measure.figure(verdict.high)}")
