"""Warnings of failed sensors, and of a map that no longer fits the movement."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from app.calibration.grades import EVR_LIMITS, LARGEST_ANGLE
from app.number_words import percent
from app.scoring.control_quality import BadChannel
from app.scoring.trial_assessment import EDGE, FEWEST, ControlWarning, JointInTrial, TrialAssessment, median_of

# Share of the time for which a failed channel was bad. Smaller shares occur when a channel rests at the edge of its
# calibrated range or the fabric is pulled; the simulated fabric drifts out of its range for up to 4 % of a trial in one
# person of ten, and for more in another one.
FAILED_SHARE = 0.05
# Degrees by which a joint's main direction may differ from that of its first trials with the same map. In simulated
# people it varies by 2 degrees; putting a real knit on again turned it by 8 to 17.
LARGEST_TURN = 6.0
EVR_FALL = 0.1  # least fall of the EVR for a warning: some joints have a low EVR from the first trial on


def sensor_warnings(trial: TrialAssessment) -> list[ControlWarning]:
    """Warn of sensors that failed in the last trial; several sensors outside their range mean that the shirt moved."""
    labels = {joint.name: joint.label for joint in trial.quality.joints}
    failed = [channel for channel in trial.quality.bad_channels if channel.share >= FAILED_SHARE]
    outside = [channel for channel in failed if not channel.silent]
    warnings = [_sensor_warning(trial, channel, labels[channel.joint]) for channel in failed if channel.silent]
    if len(outside) == 1:
        warnings.append(_sensor_warning(trial, outside[0], labels[outside[0].joint]))
    elif outside:
        where = ", ".join(dict.fromkeys(labels[channel.joint] for channel in outside))
        warnings.append(
            ControlWarning(
                kind="map",
                joint=where,
                words=f"The shirt does not sit as it was calibrated: {len(outside)} sensors ({where}) lay "
                f"outside their calibrated range in trial {trial.number}, and what these joints did had no effect.",
                advice="Set the shirt straight. When it was put on again, fit the calibration to it in Calibrate.",
            )
        )
    return warnings


def _sensor_warning(trial: TrialAssessment, channel: BadChannel, label: str) -> ControlWarning:
    fault = "gave no signal" if channel.silent else "lay outside its calibrated range"
    return ControlWarning(
        kind="sensor",
        joint=label,
        words=f"{label}: sensor {channel.name} {fault} for {percent(channel.share)} of trial {trial.number}; meanwhile "
        "what this joint did had no effect.",
        advice="Look at it on the Shirt page, set the shirt straight and push the plug in fully. If it stays so, mark "
        "the sensor as unused and calibrate again: the sensor is then left out.",
    )


def fit_warnings(rows: Sequence[JointInTrial]) -> list[ControlWarning]:
    """Warn when a joint's movement no longer lies along its map; `rows` are of one map."""
    rows = [row for row in rows if row.joint.direction is not None]
    if len(rows) < FEWEST:
        return []
    now, label = rows[-min(EDGE, len(rows)) :], rows[-1].joint.label
    guided = (
        " Another calibration than the standard one drives this joint: look whether it is still right."
        if rows[-1].joint.guided
        else ""
    )
    angle, evr = median_of(now, "map_angle_deg"), median_of(now, "evr")
    turn = _turn(rows)
    if turn > LARGEST_TURN:
        words = f"{label}: the movement has turned by {turn:.0f}° against the first trials with this calibration."
        advice = "Was the shirt put on again, or has it slipped? Set it straight, or calibrate again."
    elif angle > LARGEST_ANGLE and evr >= EVR_LIMITS[0]:
        words = (
            f"{label}: the movement lies {angle:.0f}° off the calibration, and "
            f"{percent(median_of(now, 'null_space_share'))} of it never reaches the control."
        )
        advice = "Repeat this joint's free movement and prompts as the person moves it while driving."
    elif evr < EVR_LIMITS[0] and evr < median_of(rows[:EDGE], "evr") - EVR_FALL:
        words = f"{label}: the main movement is clear to only {percent(evr)}, less than in the first trials."
        advice = "Ask the person to move this joint one way only; if that does not help, calibrate again."
    else:
        return []
    return [ControlWarning(kind="map", joint=label, words=words, advice=advice + guided)]


def _turn(rows: Sequence[JointInTrial]) -> float:
    """Return by how many degrees a joint's direction has turned since the first trials with this map.

    Of the last two trials the one with the smaller turn counts, so that one unusual trial makes no warning. 0 when the
    trials to be compared have other channels.
    """
    names = set(_direction(rows[-1]))
    latest = rows[-FEWEST:]
    first = [row for row in rows[:EDGE] if row not in latest and set(_direction(row)) == names]
    last = [row for row in latest if set(_direction(row)) == names]
    if not first or len(last) < FEWEST:
        return 0.0
    channels = sorted(names)
    base = np.mean([_vector(row, channels) for row in first], axis=0)
    cosines = [abs(float(base @ _vector(row, channels))) / float(np.linalg.norm(base)) for row in last]
    return float(np.degrees(np.arccos(min(1.0, max(cosines)))))


def _direction(row: JointInTrial) -> dict[str, float]:
    return row.joint.direction or {}


def _vector(row: JointInTrial, channels: list[str]) -> NDArray[np.float64]:
    return np.array([_direction(row)[channel] for channel in channels])
