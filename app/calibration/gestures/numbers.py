"""What a calibration's recordings say about one gesture: the four numbers, and the one score that they make."""

import math
from typing import Annotated, Literal

from pydantic import Field

from app.calibration.grades import CROSS_TALK_LIMIT, SIGNAL_TO_NOISE_LIMITS, SPREAD_LIMITS
from app.quantities import Document, Finite, Fraction, Name, Threshold

NumberName = Literal["signal_to_noise", "repeatability", "cross_talk", "effort"]
Positive = Annotated[Finite, Field(ge=0)]

EFFORT_LIMIT = 1.0  # FS: more than the whole span would be needed
WORST_RATIO = 10.0  # of a number to its limit: beyond, worse is no worse


class Companion(Document):
    """Another joint's movement, and how much of a gesture's own activation goes with it."""

    joint: Name
    share: Positive


class RestCheck(Document):
    """False activations as they were predicted from the first rest, and as they were counted in another."""

    predicted: Positive  # per minute
    counted: Annotated[int, Field(ge=0)]
    seconds: Positive


class HitCheck(Document):
    """Repetitions that were answered, each predicted from the others, and as they were counted."""

    predicted: Fraction
    counted: Annotated[int, Field(ge=0)]
    repetitions: Annotated[int, Field(ge=0)]


class Prediction(Document):
    """How a gesture will behave with its dead-zone and full; None where nothing was recorded that could tell."""

    false_per_minute: Positive | None  # at rest
    counted: Annotated[int, Field(ge=0)]  # passes of the dead-zone in all that was recorded at rest
    rest_seconds: Positive
    counted_at_most: Positive | None  # per minute, 95 %, from the count alone
    hit_rate: Fraction | None  # share of movements that reach half of full
    hit_at_least: Fraction | None  # 95 %, from the count alone
    rest_check: RestCheck | None
    hit_check: HitCheck | None


class FoundGesture(Document):
    """One gesture that the body can make, with the numbers that speak for it and against it."""

    name: Name
    joint: Name
    direction: Literal[1, -1]
    dead_zone: Threshold  # FS/s
    full: Threshold  # FS/s
    signal_to_noise: Positive
    repeatability: Positive | None  # spread of the repetitions' peaks / their mean
    cross_talk: Positive | None  # the larger of the two below
    effort: Positive | None = None  # FS, share of the joint's span that has to be moved for a full activation
    appears_with: Companion | None  # whose prompts it answers most
    brings: Companion | None  # who answers most while it is made
    prediction: Prediction | None = None
    score: Fraction = 0.0  # of the four numbers, `score_of`
    weakest: NumberName | None = None  # which of them lies furthest beyond its limit, None where none does


def ratios(gesture: FoundGesture) -> dict[NumberName, float]:
    """Return each number over the limit beyond which a joint is only usable, at most 10; 1 for what is not known."""

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
    """Return 1 / (1 + mean of the ratios): 1 is perfect, 0.5 stands at the limits on average."""
    return 1.0 / (1.0 + math.fsum(of_limits.values()) / len(of_limits))


def weakest_of(of_limits: dict[NumberName, float]) -> NumberName | None:
    """Return the number that lies furthest beyond its limit, None when none does."""
    worst = max(of_limits, key=lambda name: of_limits[name])
    return worst if of_limits[worst] > 1.0 else None
