"""The documents of a found gesture: its four numbers, their score, and the prediction of its behaviour."""

import math
from typing import Annotated, Literal

from pydantic import Field

from app.calibration.map_grades import CROSS_TALK_LIMIT, SIGNAL_TO_NOISE_LIMITS, SPREAD_LIMITS
from app.quantities import Document, Finite, Fraction, Name, Threshold

NumberName = Literal["signal_to_noise", "repeatability", "cross_talk", "effort"]
Positive = Annotated[Finite, Field(ge=0)]

EFFORT_LIMIT = 1.0  # FS: the whole span
WORST_RATIO = 10.0  # upper limit of a number's ratio to its limit


class Companion(Document):
    """Another joint that moves together with a gesture, and the activation as a share of the gesture's own."""

    joint: Name
    share: Positive


class RestCheck(Document):
    """False activations predicted from one recording of rest, and counted in another."""

    predicted: Positive  # per minute
    counted: Annotated[int, Field(ge=0)]
    seconds: Positive


class HitCheck(Document):
    """Hits among the repetitions: predicted for each repetition from the others, and counted."""

    predicted: Fraction
    counted: Annotated[int, Field(ge=0)]
    repetitions: Annotated[int, Field(ge=0)]


class Prediction(Document):
    """Predicted behaviour of a gesture with its dead-zone and full; None where the recordings lack the data."""

    false_per_minute: Positive | None  # at rest
    counted: Annotated[int, Field(ge=0)]  # upward crossings of the dead-zone in all that was recorded at rest
    rest_seconds: Positive
    counted_at_most: Positive | None  # per minute, upper 95 % bound computed from the count
    hit_rate: Fraction | None  # share of movements that reach half of a full activation
    hit_at_least: Fraction | None  # lower 95 % bound computed from the count
    rest_check: RestCheck | None
    hit_check: HitCheck | None


class FoundGesture(Document):
    """One gesture that the body can make, with its four numbers and their score."""

    name: Name
    joint: Name
    direction: Literal[1, -1]
    dead_zone: Threshold  # FS/s
    full: Threshold  # FS/s
    signal_to_noise: Positive
    repeatability: Positive | None  # spread of the repetitions' peaks / their mean
    cross_talk: Positive | None  # the larger share of `appears_with` and `brings`
    effort: Positive | None = None  # FS, share of the joint's span to move for a full activation
    appears_with: Companion | None  # the joint whose prompts activate this gesture most
    brings: Companion | None  # the joint that is activated most while this gesture is made
    prediction: Prediction | None = None
    score: Fraction = 0.0  # of the four numbers, by `score_of`
    weakest: NumberName | None = None  # the number furthest beyond its limit, None where none is beyond


def ratios(gesture: FoundGesture) -> dict[NumberName, float]:
    """Return the ratio of each number to its limit for the grade `good`, at most 10; 1 for an unknown number.

    For the signal to noise, which has a lower limit, the limit over the number.
    """

    def _over(value: float | None, limit: float) -> float:
        return 1.0 if value is None else min(value / limit, WORST_RATIO)

    signal = gesture.signal_to_noise
    return {
        "signal_to_noise": min(SIGNAL_TO_NOISE_LIMITS[0] / signal, WORST_RATIO) if signal > 0 else WORST_RATIO,
        "repeatability": _over(gesture.repeatability, SPREAD_LIMITS[0]),
        "cross_talk": _over(gesture.cross_talk, CROSS_TALK_LIMIT),
        "effort": _over(gesture.effort, EFFORT_LIMIT),
    }


def score_of(of_limits: dict[NumberName, float]) -> float:
    """Return 1 / (1 + mean of the ratios): 1 is perfect, 0.5 means at the limits on average."""
    return 1.0 / (1.0 + math.fsum(of_limits.values()) / len(of_limits))


def weakest_of(of_limits: dict[NumberName, float]) -> NumberName | None:
    """Return the number that is furthest beyond its limit, None when none is beyond."""
    worst = max(of_limits, key=lambda name: of_limits[name])
    return worst if of_limits[worst] > 1.0 else None
