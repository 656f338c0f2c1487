"""Warnings for the clinician from the control quality of a patient's trials, each with advice."""

from collections.abc import Sequence
from itertools import groupby
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.map_grades import EVR_LIMITS, LARGEST_ANGLE
from app.layout import joint_title, joint_within
from app.scoring.control_quality import BadChannel
from app.scoring.joint_quality import JointQuality
from app.scoring.trend import mann_kendall
from app.scoring.trial_assessment import (
    EDGE,
    FEWEST,
    ControlWarning,
    JointInTrial,
    Kind,
    TrialAssessment,
    comparable_trials,
    median_of,
    trials_of_joint,
)
from app.texts import Figure, Text, Value, in_sequence

# Share of the dead-zone: noise of a third of the dead-zone activates a gesture by chance about once a minute.
NOISE_SHARE = 1.0 / 3.0
NOISE_GROWTH = 1.5  # ratio to the first trials' noise; between sessions, constant noise differs by a factor of 1.2
SPAN_FALL = 0.08  # share of the first session's span: a loss of 2 % a session over five sessions
SPAN_FALL_WITHIN = 0.15  # share of the session's first trials' span; smaller strokes on purpose make a smaller fall
LEAST_TRIALS = 8  # of one session, for a trend within it, as for a learning curve
LEAST_SESSIONS = 5  # for a trend over sessions; four values rise or fall throughout by chance once in twelve times
SIGNIFICANCE = 0.05

# Share of the time for which a failed channel was bad. Smaller shares occur when a channel rests at the edge of its
# calibrated range or the fabric is pulled; the simulated fabric drifts out of its range for up to 4 % of a trial in one
# person of ten, and for more in another one.
FAILED_SHARE = 0.05

# Degrees by which a joint's main direction may differ from that of its first trials with the same map. In simulated
# people it varies by 2 degrees; putting a real knit on again turned it by 8 to 17.
LARGEST_TURN = 6.0
EVR_FALL = 0.1  # least fall of the EVR for a warning: some joints have a low EVR from the first trial on

ORDER: tuple[Kind, ...] = ("sensor", "map", "noise", "span")


class ControlWarnings(NamedTuple):
    """All warnings, and a note on what needs more trials; None when there are enough."""

    warnings: list[ControlWarning]
    note: Text | None


def control_warnings(trials: Sequence[TrialAssessment], map_version: int | None = None) -> ControlWarnings:
    """Return the warnings from the trials of one patient.

    Parameters
    ----------
    trials
        In the order driven, without discarded ones.
    map_version
        The patient's newest map, that of the last trial when not given. Warnings of sensors and of the map's fit are
        made from trials with this map only.
    """
    if not trials:
        return ControlWarnings([], None)
    newest = trials[-1].map_version if map_version is None else map_version
    of_map = [trial for trial in trials if trial.map_version == newest]
    warnings = sensor_warnings(of_map[-1]) if of_map else []
    for name in dict.fromkeys(joint.name for joint in trials[-1].quality.joints):
        warnings += fit_warnings(trials_of_joint(of_map, name))
        every = comparable_trials(trials_of_joint(trials, name))
        warnings += noise_warnings(trials_of_joint(of_map, name), every)
        warnings += span_warnings([row for row in every if row.trial.task == trials[-1].task])
    return ControlWarnings(sorted(warnings, key=lambda warning: ORDER.index(warning.kind)), _note(trials))


def _note(trials: Sequence[TrialAssessment]) -> Text | None:
    """Return in a sentence how many more trials the trends need; None when there are enough."""
    same_task = [trial for trial in trials if trial.task == trials[-1].task]
    sessions = len({trial.session for trial in same_task})
    in_last_session = sum(trial.session == trials[-1].session for trial in same_task)
    if sessions >= LEAST_SESSIONS or in_last_session >= LEAST_TRIALS:
        return None
    return Text(
        "warning-few-trials",
        least_trials=LEAST_TRIALS,
        least_sessions=LEAST_SESSIONS,
        trials=in_last_session,
        sessions=sessions,
    )


def sensor_warnings(trial: TrialAssessment) -> list[ControlWarning]:
    """Warn of sensors that failed in the last trial; several sensors outside their range mean that the shirt moved."""
    joints = {joint.name: joint for joint in trial.quality.joints}
    failed = [channel for channel in trial.quality.bad_channels if channel.share >= FAILED_SHARE]
    outside = [channel for channel in failed if not channel.silent]
    warnings = [_sensor_warning(trial, channel, joints[channel.joint]) for channel in failed if channel.silent]
    if len(outside) == 1:
        warnings.append(_sensor_warning(trial, outside[0], joints[outside[0].joint]))
    elif outside:
        moved = [joints[name] for name in dict.fromkeys(channel.joint for channel in outside)]
        names = [joint_within(joint) for joint in moved]
        warnings.append(
            ControlWarning(
                kind="map",
                joint=Text("warning-joints", joints=[joint_title(joint) for joint in moved]),
                message=Text("warning-shirt", count=len(outside), joints=names, trial=trial.number),
                advice=Text("warning-shirt-advice"),
            )
        )
    return warnings


def _sensor_warning(trial: TrialAssessment, channel: BadChannel, joint: JointQuality) -> ControlWarning:
    title = joint_title(joint)
    values: dict[str, Value] = {
        "joint": title,
        "sensor": channel.name,
        "percent": Figure(100 * channel.share),
        "trial": trial.number,
    }
    return ControlWarning(
        kind="sensor",
        joint=title,
        message=Text("warning-sensor-silent" if channel.silent else "warning-sensor-range", **values),
        advice=Text("warning-sensor-advice"),
    )


def fit_warnings(rows: Sequence[JointInTrial]) -> list[ControlWarning]:
    """Warn when a joint's movement no longer lies along its map; `rows` are of one map."""
    rows = [row for row in rows if row.joint.direction is not None]
    if len(rows) < FEWEST:
        return []
    last_trials, title = rows[-min(EDGE, len(rows)) :], joint_title(rows[-1].joint)
    guided = [Text("warning-other-map")] if rows[-1].joint.guided else []
    angle, evr = median_of(last_trials, "map_angle_deg"), median_of(last_trials, "evr")
    turn = _turn(rows)
    if turn > LARGEST_TURN:
        finding = Text("warning-turned", joint=title, degrees=Figure(turn))
        advice = Text("warning-turned-advice")
    elif angle > LARGEST_ANGLE and evr >= EVR_LIMITS[0]:
        lost = Figure(100 * median_of(last_trials, "null_space_share"))
        finding = Text("warning-off-map", joint=title, degrees=Figure(angle), percent=lost)
        advice = Text("warning-off-map-advice")
    elif evr < EVR_LIMITS[0] and evr < median_of(rows[:EDGE], "evr") - EVR_FALL:
        finding = Text("warning-unclear", joint=title, percent=Figure(100 * evr))
        advice = Text("warning-unclear-advice")
    else:
        return []
    return [ControlWarning(kind="map", joint=title, message=finding, advice=in_sequence([advice, *guided]))]


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


def noise_warnings(of_map: Sequence[JointInTrial], every: Sequence[JointInTrial]) -> list[ControlWarning]:
    """Warn when a joint's noise at rest is near its dead-zone, or has grown."""
    measured = [row for row in of_map if row.joint.rest_rate is not None]
    if len(measured) >= FEWEST and (joint := measured[-1].joint).dead_zone is not None:
        now, dead_zone, title = median_of(measured[-EDGE:], "rest_rate"), joint.dead_zone, joint_title(joint)
        if now > NOISE_SHARE * dead_zone:
            return [
                ControlWarning(
                    kind="noise",
                    joint=title,
                    message=Text(
                        "warning-trembles",
                        joint=title,
                        percent=Figure(100 * now),
                        counts_from=Figure(100 * dead_zone),
                        better_from=Figure(400 * now),
                    ),
                    advice=Text("warning-trembles-advice"),
                )
            ]
    rows = [row for row in every if row.joint.rest_rate is not None]
    if len(rows) < LEAST_TRIALS:
        return []
    values = [float(row.joint.rest_rate or 0.0) * _unit(row) for row in rows]
    first, last = float(np.median(values[:EDGE])), float(np.median(values[-EDGE:]))
    if first <= 0 or last < NOISE_GROWTH * first or not _has_trend(values, "rises"):
        return []
    title = joint_title(rows[-1].joint)
    return [
        ControlWarning(
            kind="noise",
            joint=title,
            message=Text("warning-noise", joint=title, ratio=Figure(last / first, 1)),
            advice=Text("warning-noise-advice"),
        )
    ]


def span_warnings(every: Sequence[JointInTrial]) -> list[ControlWarning]:
    """Warn when a joint's movement becomes smaller on one task, over sessions or within the last session.

    No warning when the person also needs fewer and fewer movements per metre: that is skill and no loss.
    """
    rows = [row for row in every if row.joint.span]
    if not rows or _has_trend(_per_metre(rows), "falls"):
        return []
    title = joint_title(rows[-1].joint)
    sessions = [
        float(np.median([float(row.joint.span or 0.0) for row in group]))
        for _, group in groupby(rows, key=lambda row: row.trial.session)
    ]
    in_last_session = [float(row.joint.span or 0.0) for row in rows if row.trial.session == rows[-1].trial.session]
    has_fallen = len(sessions) >= LEAST_SESSIONS and sessions[-1] < (1 - SPAN_FALL) * sessions[0]
    if has_fallen and _has_trend(sessions, "falls"):
        fall = 1 - sessions[-1] / sessions[0]
        finding = Text("warning-smaller", joint=title, percent=Figure(100 * fall), sessions=len(sessions))
        advice = Text("warning-smaller-advice")
    elif len(in_last_session) >= LEAST_TRIALS and _has_trend(in_last_session, "falls"):
        first, last = float(np.median(in_last_session[:EDGE])), float(np.median(in_last_session[-EDGE:]))
        if last >= (1 - SPAN_FALL_WITHIN) * first:
            return []
        finding = Text("warning-tired", joint=title, percent=Figure(100 * (1 - last / first)))
        advice = Text("warning-tired-advice")
    else:
        return []
    return [ControlWarning(kind="span", joint=title, message=finding, advice=advice)]


def _unit(row: JointInTrial) -> float:
    """Return the full scale of the trial's map in signal units; 0 when unknown."""
    return (row.joint.span or 0.0) / row.joint.span_share if row.joint.span_share else 0.0


def _per_metre(rows: Sequence[JointInTrial]) -> list[float]:
    rates = (row.trial.quality.activations_per_metre for row in rows)
    return [value for value in rates if value is not None]


def _has_trend(values: Sequence[float], direction: Literal["falls", "rises"]) -> bool:
    trend = mann_kendall(values)
    return trend.p < SIGNIFICANCE and trend.direction == direction
