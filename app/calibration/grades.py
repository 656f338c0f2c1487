"""Grades a joint's map, with the reasons in words and what to do about them."""

import math
from dataclasses import dataclass

from app.calibration.profile import Grade
from app.number_format import percent

# Limits come in pairs: beyond the first a map is `usable` only, beyond the second its movement has to be repeated.
EVR_LIMITS = (0.80, 0.50)  # the paper reports 80-90 %
SIGNAL_TO_NOISE_LIMITS = (8.0, 4.0)  # the dead-zone alone is 4 times the noise
SPREAD_LIMITS = (0.30, 0.60)  # of the repetitions' peaks, upper limits
PROMPTED_SHARE_LIMITS = (0.30, 0.10)  # of the span
CROSS_TALK_LIMIT = 0.30  # above it, two gestures are active together
AGREEMENT_LIMITS = (0.90, 0.70)  # of the repetitions' directions
UNPROMPTED = "It was not prompted, so which way it counts is not known: prompt it."
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
    strongest_cross_talk: tuple[str, float] | None  # joint that answers most, and its share
    channels: int  # in the map
    channels_out: int  # left out of it
    prompted_share: float | None  # extent of the prompted movements as a share of the span
    span_from_prompts: bool  # whether the prompts set the span, not the free movement
    had_rest: bool


def signal_word(signal_to_noise: float) -> str:
    """Return how strong a signal is, in a word."""
    fair, weak = SIGNAL_TO_NOISE_LIMITS
    return "strong" if signal_to_noise >= fair else "fair" if signal_to_noise >= weak else "weak"


def repeats_word(spread: float) -> str:
    """Return how well a movement repeats, in a word, from the spread of its repetitions' peaks."""
    fair, poor = SPREAD_LIMITS
    return "well" if spread <= fair else "fairly" if spread <= poor else "poorly"


def grade(measured: JointMeasurements) -> tuple[Grade, str]:
    """Return the worst grade over all criteria, and the sentences for them, the worst first."""
    sentences = [*_of_movement(measured), *_of_prompts(measured), *_of_channels(measured)]
    sentences.sort(key=lambda finding: -ORDER[finding[0]])
    worst: Grade = sentences[0][0] if sentences else "good"
    texts = [text for _, text in sentences if text]
    if worst == "good":
        texts.insert(0, _good_sentence(measured))
    return worst, " ".join(texts)


def _of_movement(measured: JointMeasurements) -> list[tuple[Grade, str]]:
    findings: list[tuple[Grade, str]] = []
    if not measured.reaches_full:
        findings.append(("repeat", "The movement does not rise above the noise: repeat it larger and quicker."))
    elif measured.signal_to_noise < SIGNAL_TO_NOISE_LIMITS[0]:
        bad = measured.signal_to_noise < SIGNAL_TO_NOISE_LIMITS[1]
        advice = "rest quite still, then repeat it larger" if bad else "a larger or quicker movement would be safer"
        findings.append(
            (
                "repeat" if bad else "usable",
                f"It moves only {measured.signal_to_noise:.1f} times above the noise: {advice}.",
            )
        )
    if measured.evr < EVR_LIMITS[0]:
        bad = measured.evr < EVR_LIMITS[1]
        advice = "repeat the free movement with this joint moved one way only" if bad else "keep to one movement of it"
        findings.append(
            (
                "repeat" if bad else "usable",
                f"The main movement is clear to {math.floor(100 * measured.evr)} % only, "
                f"below the usual 80 %: {advice}.",
            )
        )
    if not measured.had_rest:
        findings.append(("good", "No rest was recorded: the noise is that of the stillest half second."))
    return findings


def _of_prompts(measured: JointMeasurements) -> list[tuple[Grade, str]]:
    if measured.agreement is None:
        return [("usable", UNPROMPTED)]
    findings: list[tuple[Grade, str]] = []
    if measured.agreement < AGREEMENT_LIMITS[0]:
        bad = measured.agreement < AGREEMENT_LIMITS[1]
        finding = f"The prompted movements point both ways ({percent(measured.agreement)} of them one way)"
        findings.append(("repeat" if bad else "usable", f"{finding}: repeat them in time with the cue."))
    if measured.prompted_share is not None and measured.prompted_share < PROMPTED_SHARE_LIMITS[0]:
        bad = measured.prompted_share < PROMPTED_SHARE_LIMITS[1]
        finding = f"The prompted movements go through only {percent(measured.prompted_share)} of the free one's span"
        findings.append(("repeat" if bad else "usable", f"{finding}: repeat them larger, and in time with the cue."))
    if measured.repeatability is not None and measured.repeatability > SPREAD_LIMITS[0]:
        bad = measured.repeatability > SPREAD_LIMITS[1]
        finding = f"The repetitions differ by {percent(measured.repeatability)}"
        advice = "repeat them evenly" if bad else "more even ones would drive more evenly"
        findings.append(("repeat" if bad else "usable", f"{finding}: {advice}."))
    if measured.angle_deg is not None and measured.angle_deg > LARGEST_ANGLE:
        finding = f"The prompted movement is {measured.angle_deg:.0f} degrees away from the free one"
        findings.append(("usable", f"{finding}: the prompted direction is used, check it in Try it."))
    if measured.strongest_cross_talk is not None and measured.strongest_cross_talk[1] > CROSS_TALK_LIMIT:
        name, share = measured.strongest_cross_talk
        finding = f"'{name}' answers too, with {percent(min(share, 9.99))} of its own activation"
        findings.append(("usable", f"{finding}: move this joint alone, or do not bind both."))
    if measured.span_from_prompts:
        findings.append(("good", "It moved little this way in the free movement: the span is that of the prompts."))
    return findings


def _of_channels(measured: JointMeasurements) -> list[tuple[Grade, str]]:
    if measured.channels == 1 and measured.channels_out:
        return [("usable", "Only one of its sensors is left: check the others on the Shirt page.")]
    if measured.channels_out:
        return [("good", f"Sensors left out: {measured.channels_out} of {measured.channels + measured.channels_out}.")]
    return []


def _good_sentence(measured: JointMeasurements) -> str:
    sentence = f"Clear main movement: {percent(measured.evr)}. Signal: {signal_word(measured.signal_to_noise)}."
    if measured.repeatability is not None:
        sentence += f" Repeats {repeats_word(measured.repeatability)}."
    return sentence
