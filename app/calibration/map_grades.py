"""Grades a joint's map, with the reasons in words and what to do about them."""

import math
from dataclasses import dataclass
from typing import Literal

from app.calibration.profile import Grade
from app.texts import Figure, Text

Strength = Literal["strong", "fair", "weak"]

# Limits come in pairs: beyond the first a map is `usable` only, beyond the second its movement has to be repeated.
EVR_LIMITS = (0.80, 0.50)  # the paper reports 80-90 %
SIGNAL_TO_NOISE_LIMITS = (8.0, 4.0)  # the dead-zone alone is 4 times the noise
SPREAD_LIMITS = (0.30, 0.60)  # of the repetitions' peaks, upper limits
PROMPTED_SHARE_LIMITS = (0.30, 0.10)  # of the span
CROSS_TALK_LIMIT = 0.30  # above it, two gestures are active together
AGREEMENT_LIMITS = (0.90, 0.70)  # of the repetitions' directions
UNPROMPTED = Text("grade-unprompted")
LARGEST_ANGLE = 30.0  # degrees between free and prompted movement
ORDER: dict[Grade, int] = {"good": 0, "usable": 1, "repeat": 2}


@dataclass(frozen=True, slots=True)
class JointMeasurements:
    """The measurements of one joint from a calibration; None where the recordings lack the data."""

    evr: float
    signal_to_noise: float
    reaches_full: bool  # whether any movement left the dead-zone
    repeatability: float | None
    agreement: float | None  # None: never prompted
    angle_deg: float | None
    strongest_cross_talk: tuple[Text | str, float] | None  # what the joint is called that answers most, and its share
    channels: int  # in the map
    channels_out: int  # left out of it
    prompted_share: float | None  # extent of the prompted movements as a share of the span
    span_from_prompts: bool  # whether the prompts set the span, not the free movement
    had_rest: bool


def signal_strength(signal_to_noise: float) -> Strength:
    """Return how strong a signal is."""
    fair, weak = SIGNAL_TO_NOISE_LIMITS
    return "strong" if signal_to_noise >= fair else "fair" if signal_to_noise >= weak else "weak"


def signal_word(signal_to_noise: float) -> Text:
    """Return how strong a signal is, in a word."""
    return Text(f"grade-signal-{signal_strength(signal_to_noise)}")


def repeats_word(spread: float) -> Text:
    """Return how well a movement repeats, in a word, from the spread of its repetitions' peaks."""
    fair, poor = SPREAD_LIMITS
    how = "well" if spread <= fair else "fairly" if spread <= poor else "poorly"
    return Text(f"grade-repeats-{how}")


def grade(measured: JointMeasurements) -> tuple[Grade, tuple[Text, ...]]:
    """Return the worst grade over all criteria, and the sentences for them, the worst first."""
    findings = [*_of_movement(measured), *_of_prompts(measured), *_of_channels(measured)]
    findings.sort(key=lambda finding: -ORDER[finding[0]])
    worst: Grade = findings[0][0] if findings else "good"
    sentences = [sentence for _, sentence in findings]
    return worst, tuple([*_good_sentences(measured), *sentences] if worst == "good" else sentences)


def _of_movement(measured: JointMeasurements) -> list[tuple[Grade, Text]]:
    findings: list[tuple[Grade, Text]] = []
    if not measured.reaches_full:
        findings.append(("repeat", Text("grade-no-movement")))
    elif measured.signal_to_noise < SIGNAL_TO_NOISE_LIMITS[0]:
        rating = _rating(bad=measured.signal_to_noise < SIGNAL_TO_NOISE_LIMITS[1])
        findings.append((rating, Text("grade-signal", ratio=Figure(measured.signal_to_noise, 1), rating=rating)))
    if measured.evr < EVR_LIMITS[0]:
        rating = _rating(bad=measured.evr < EVR_LIMITS[1])
        findings.append((rating, Text("grade-clear", percent=math.floor(100 * measured.evr), rating=rating)))
    if not measured.had_rest:
        findings.append(("good", Text("grade-no-rest")))
    return findings


def _of_prompts(measured: JointMeasurements) -> list[tuple[Grade, Text]]:
    if measured.agreement is None:
        return [("usable", UNPROMPTED)]
    findings: list[tuple[Grade, Text]] = []
    if measured.agreement < AGREEMENT_LIMITS[0]:
        rating = _rating(bad=measured.agreement < AGREEMENT_LIMITS[1])
        findings.append((rating, Text("grade-agreement", percent=Figure(100 * measured.agreement))))
    if measured.prompted_share is not None and measured.prompted_share < PROMPTED_SHARE_LIMITS[0]:
        rating = _rating(bad=measured.prompted_share < PROMPTED_SHARE_LIMITS[1])
        findings.append((rating, Text("grade-small-prompts", percent=Figure(100 * measured.prompted_share))))
    if measured.repeatability is not None and measured.repeatability > SPREAD_LIMITS[0]:
        rating = _rating(bad=measured.repeatability > SPREAD_LIMITS[1])
        findings.append((rating, Text("grade-uneven", percent=Figure(100 * measured.repeatability), rating=rating)))
    if measured.angle_deg is not None and measured.angle_deg > LARGEST_ANGLE:
        findings.append(("usable", Text("grade-angle", degrees=Figure(measured.angle_deg))))
    if measured.strongest_cross_talk is not None and measured.strongest_cross_talk[1] > CROSS_TALK_LIMIT:
        name, share = measured.strongest_cross_talk
        findings.append(("usable", Text("grade-cross-talk", joint=name, percent=Figure(100 * min(share, 9.99)))))
    if measured.span_from_prompts:
        findings.append(("good", Text("grade-span-of-prompts")))
    return findings


def _of_channels(measured: JointMeasurements) -> list[tuple[Grade, Text]]:
    if measured.channels == 1 and measured.channels_out:
        return [("usable", Text("grade-one-sensor"))]
    if measured.channels_out:
        every = measured.channels + measured.channels_out
        return [("good", Text("grade-sensors-out", count=measured.channels_out, every=every))]
    return []


def _rating(*, bad: bool) -> Grade:
    return "repeat" if bad else "usable"


def _good_sentences(measured: JointMeasurements) -> list[Text]:
    clear = Text("grade-good", percent=Figure(100 * measured.evr), signal=signal_word(measured.signal_to_noise))
    if measured.repeatability is None:
        return [clear]
    return [clear, Text("grade-good-repeats", how=repeats_word(measured.repeatability))]
