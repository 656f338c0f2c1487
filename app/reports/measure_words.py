"""The words, units and digits of the measures on a report; equal to those on the pages (texts/en/measures.js)."""

import math
from collections.abc import Mapping
from typing import Any, Final, NamedTuple

from app.scoring.learning import MEASURES as LEARNING
from app.scoring.verdict.measure_verdict import Verdict
from app.scoring.verdict.measure_verdict import Word as VerdictWord


class MeasureWords(NamedTuple):
    """The name of a measure for people, and its digits behind the point."""

    name: str
    digits: int


MEASURE_WORDS: Final[dict[str, MeasureWords]] = {
    "stages_done": MeasureWords("Stages done", 0),
    "follow_error_rms": MeasureWords("Usual error of the distance to the leader", 2),
    "follow_error_max": MeasureWords("Largest error of the distance to the leader", 2),
    "follow_near": MeasureWords("Share of time near the asked distance", 0),
    "heading_error_deg": MeasureWords("Angle off the mark", 0),
    "turn_drift": MeasureWords("Moved off the spot", 2),
    "cones_touched": MeasureWords("Cones touched", 0),
    "gap_clearance": MeasureWords("Narrowest clearance in a gap", 2),
    "door_contacts": MeasureWords("Contacts with door or gap", 0),
    "e_diff": MeasureWords("Area off the path", 2),
    "dist": MeasureWords("Distance driven", 2),
    "time": MeasureWords("Time", 1),
    "dist_ratio": MeasureWords("Distance over path length", 2),
    "cross_track_rms": MeasureWords("Usual distance from the path", 2),
    "cross_track_max": MeasureWords("Largest distance from the path", 2),
    "mean_speed": MeasureWords("Mean speed", 2),
    "stops": MeasureWords("Stops", 0),
    "collisions": MeasureWords("Contacts", 0),
    "contact_time": MeasureWords("Time in contact", 1),
    "turn_reversals": MeasureWords("Changes of turning", 0),
    "pulses_per_metre": MeasureWords("Commands per metre", 1),
    "sparc": MeasureWords("Smoothness", 2),
    "ldlj": MeasureWords("Smoothness, another measure", 2),
}

VERDICT_WORDS: Final[dict[VerdictWord, str]] = {
    "better": "better than noise",
    "within": "within noise",
    "worse": "worse than noise",
    "too few": "too few trials",
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
    if value is None or not math.isfinite(value):
        return ""
    return _joined(_figure(name, value), name)


def noise_words(name: str, verdict: Verdict) -> str:
    """Return from where to where a level is within noise; "" for too few trials."""
    if verdict.low is None or verdict.high is None:
        return ""
    return _joined(f"{_figure(name, verdict.low)} to {_figure(name, verdict.high)}", name)


def _figure(name: str, value: float) -> str:
    _, unit, factor = LEARNING[name]
    digits = MEASURE_WORDS[name].digits
    if not digits and not unit and value != round(value):
        digits = 1  # a mean of counts
    return f"{value * factor:.{digits}f}".replace("-", "\u2212")


def _joined(figure: str, name: str) -> str:
    unit = LEARNING[name].unit
    return f"{figure}{unit}" if unit == "°" else f"{figure} {unit}".rstrip()


def amount(count: int, one: str, many: str = "") -> str:
    """Return a count with its noun: 1 trial, 2 trials."""
    return f"{count} {one if count == 1 else many or f'{one}s'}"
