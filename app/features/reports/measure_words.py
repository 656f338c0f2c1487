"""Levels of measures, shares and noise in the words of a report."""

import math

from app.scoring.measures import TRIAL_MEASURES
from app.scoring.verdict.measure_verdict import Verdict


def with_unit(name: str, value: float | None) -> str:
    """Return a level of a measure in words; "" for None."""
    return "" if value is None or not math.isfinite(value) else TRIAL_MEASURES[name].level(value)


def share_words(share: float | None) -> str:
    """Return a share in percent, in words; "" for None."""
    return "" if share is None else f"{100 * share:.0f} %"


def noise_words(name: str, verdict: Verdict) -> str:
    """Return from where to where a level is within noise; "" for too few trials, or no word."""
    if verdict.low is None or verdict.high is None:
        return ""
    measure = TRIAL_MEASURES[name]
    return measure.with_unit(f"{measure.figure(verdict.low)} to {measure.figure(verdict.high)}")
