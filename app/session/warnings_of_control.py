"""What a clinician had better look at, from how well the trials were controlled: each with what to do about it."""

from collections.abc import Iterable, Sequence
from itertools import groupby
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.grades import EVR_LIMITS, LARGEST_ANGLE
from app.quantities import Document
from app.session.control_quality import ControlQuality
from app.session.joint_quality import JointQuality
from app.session.trend import mann_kendall

EDGE = 3  # trials at either end whose median stands for "at first" and "now"
FEWEST = 2  # trials that must agree before anything but a sensor is warned of
DROPPED = 0.02  # of the time: a channel that fails for less of it rested at the edge of its range, or somebody pulled
DEAD = 0.5  # of the time: from here a channel counts as dead and not as loose
# Degrees by which a joint's main direction may turn against its first trials with the same map. A simulated person's
# wanders by 2 degrees; putting a real knit on again turned it by 8 to 17.
TURNED = 6.0
EVR_FALL = 0.1  # by which the EVR must have fallen, too: some joints move in two ways from the first day
# Of the dead-zone: with noise at a third of it, chance alone activates a gesture about once a minute.
NOISE_SHARE = 1.0 / 3.0
NOISE_GROWTH = 1.5  # times that of the first trials: between sessions, steady noise differs by 1.2 at most
SPAN_FALL = 0.08  # of the first session's: what a loss of 2 % a session comes to within five sessions
SPAN_FALL_WITHIN = 0.15  # of this session's first trials: strokes chosen a little smaller make less
LEAST_TRIALS = 8  # of one session, for a trend within it; the learning curves ask for as many
LEAST_SESSIONS = 5  # for a trend over sessions: four in one order are chance once in twelve times
SIGNIFICANCE = 0.05

Kind = Literal["sensor", "map", "noise", "span"]


class JudgedTrial(NamedTuple):
    """A trial that counts, with how well it was controlled."""

    id: int
    number: int
    session: int  # 1, 2, 3 ... of the patient's visits
    map_version: int
    quality: ControlQuality


class ControlWarning(Document):
    """One thing to look at."""

    kind: Kind
    joint: str  # what people call it
    words: str  # what was seen
    advice: str  # what to do


class Found(NamedTuple):
    """All warnings, and what cannot be told yet; the note is empty when there are trials enough."""

    warnings: list[ControlWarning]
    note: str


class _Row(NamedTuple):
    """One joint in one trial."""

    trial: JudgedTrial
    joint: JointQuality


def warnings_of_control(trials: Sequence[JudgedTrial], map_version: int | None = None) -> Found:
    """Return what to look at.

    Parameters
    ----------
    trials
        Of one patient, in the order driven, discarded ones left out.
    map_version
        The patient's newest map: of an older one, nothing is said of sensors and fit any more. The last trial's when
        not given.
    """
    if not trials:
        return Found([], "")
    newest = trials[-1].map_version if map_version is None else map_version
    of_map = [trial for trial in trials if trial.map_version == newest]
    found = _sensors(of_map[-1]) if of_map else []
    for name in dict.fromkeys(joint.name for joint in trials[-1].quality.joints):
        found += _fit(_rows(of_map, name))
        every = _comparable(_rows(trials, name))
        found += _noise(_rows(of_map, name), every)
        found += _span(every, trials)
    order: list[Kind] = ["sensor", "map", "noise", "span"]
    return Found(sorted(found, key=lambda one: order.index(one.kind)), _note(trials))


def _sensors(trial: JudgedTrial) -> list[ControlWarning]:
    """Name the sensors that failed in the last trial."""
    found = []
    for channel, share in trial.quality.bad_channels.items():
        if share < DROPPED:
            continue
        joint = next((one.label for one in trial.quality.joints if channel in one.channels), "")
        dead = share >= DEAD
        found.append(
            ControlWarning(
                kind="sensor",
                joint=joint,
                words=f"{joint}: sensor {channel} {'gave no usable signal' if dead else 'dropped out'} for {share:.0%} "
                f"of trial {trial.number}; meanwhile the gestures of this joint did nothing.",
                advice=f"Look at {channel} on the Shirt page and press its plug home. If it stays silent, mark it as "
                "unused and calibrate again: the map is then built without it.",
            )
        )
    return found


def _fit(rows: Sequence[_Row]) -> list[ControlWarning]:
    """Tell when a joint's movement no longer lies along its map; `rows` are of one map."""
    told = [row for row in rows if row.joint.direction is not None]
    if len(told) < FEWEST:
        return []
    now, label = told[-min(EDGE, len(told)) :], told[-1].joint.label
    guided = " A guided map decodes this joint: look whether it still does as meant." if told[-1].joint.guided else ""
    angle, evr = _median(now, "map_angle_deg"), _median(now, "evr")
    turn = _turn(told)
    if turn > TURNED:
        words = f"{label}: the movement has turned by {turn:.0f}° against the first trials with this map."
        advice = "Was the shirt put on again, or has it slipped? Set it straight, or calibrate again."
    elif angle > LARGEST_ANGLE and evr >= EVR_LIMITS[0]:
        words = (
            f"{label}: the movement lies {angle:.0f}° beside the map, and {_median(now, 'null_space_share'):.0%} of it "
            "never reaches the control."
        )
        advice = "Repeat this joint's free movement and prompts as the person moves it while driving."
    elif evr < EVR_LIMITS[0] and evr < _median(told[:EDGE], "evr") - EVR_FALL:
        words = f"{label}: one direction explains only {evr:.0%} of the movement, less than in the first trials."
        advice = "Ask the person to move this joint one way only; if that does not help, calibrate again."
    else:
        return []
    return [ControlWarning(kind="map", joint=label, words=words, advice=advice + guided)]


def _turn(told: Sequence[_Row]) -> float:
    """Return by how many degrees a joint's direction has turned since the first trials of this map.

    The smallest turn of the last two trials counts, so that one odd trial is no warning.
    """
    latest = told[-FEWEST:]
    first = [row for row in told[:EDGE] if row not in latest and set(_direction(row)) == set(_direction(told[-1]))]
    alike = [row for row in latest if set(_direction(row)) == set(_direction(told[-1]))]
    if not first or len(alike) < FEWEST:
        return 0.0
    channels = sorted(_direction(told[-1]))
    base = np.mean([_vector(row, channels) for row in first], axis=0)
    cosines = [abs(float(base @ _vector(row, channels))) / float(np.linalg.norm(base)) for row in alike]
    return float(np.degrees(np.arccos(min(1.0, max(cosines)))))


def _noise(of_map: Sequence[_Row], every: Sequence[_Row]) -> list[ControlWarning]:
    """Tell when a joint's noise at rest comes near its dead-zone, or has grown."""
    known = [row for row in of_map if row.joint.rest_rate is not None]
    if len(known) >= FEWEST and known[-1].joint.dead_zone is not None:
        now, dead_zone, label = _median(known[-EDGE:], "rest_rate"), known[-1].joint.dead_zone, known[-1].joint.label
        if now > NOISE_SHARE * dead_zone:
            return [
                ControlWarning(
                    kind="noise",
                    joint=label,
                    words=f"{label}: at rest the noise is {now:.2f} FS/s, too near the dead-zone of "
                    f"{dead_zone:.2f} FS/s: the gesture may activate by itself.",
                    advice="Look for tremor, a tired patient or a loose plug. Then raise the dead-zone on the Controls "
                    f"page to at least {4 * now:.2f} FS/s, or lower the cutoff of the tremor damping.",
                )
            ]
    rows = [row for row in every if row.joint.rest_rate is not None]
    if len(rows) < LEAST_TRIALS:
        return []
    values = [float(row.joint.rest_rate or 0.0) * _unit(row) for row in rows]
    first, last = float(np.median(values[:EDGE])), float(np.median(values[-EDGE:]))
    if first <= 0 or last < NOISE_GROWTH * first or not _goes(values, "rises"):
        return []
    label = rows[-1].joint.label
    return [
        ControlWarning(
            kind="noise",
            joint=label,
            words=f"{label}: the noise at rest has grown to {last / first:.1f} times that of the first trials.",
            advice="Look for tremor, a tired patient or a loose plug on the Shirt page. When it stays, repeat the rest "
            "of the calibration, so that the dead-zone is set by it.",
        )
    ]


def _span(every: Sequence[_Row], trials: Sequence[JudgedTrial]) -> list[ControlWarning]:
    """Tell when a joint moves less and less, over sessions or within the last one.

    Smaller movements that are also fewer for the same way are skill and no loss: then nothing is said.
    """
    rows = [row for row in every if row.joint.span]
    if not rows or _goes(_per_metre(trials), "falls"):
        return []
    label = rows[-1].joint.label
    sessions = [
        float(np.median([float(row.joint.span or 0.0) for row in group]))
        for _, group in groupby(rows, key=lambda row: row.trial.session)
    ]
    here = [float(row.joint.span or 0.0) for row in rows if row.trial.session == rows[-1].trial.session]
    if len(sessions) >= LEAST_SESSIONS and sessions[-1] < (1 - SPAN_FALL) * sessions[0] and _goes(sessions, "falls"):
        fall = 1 - sessions[-1] / sessions[0]
        words = f"{label}: the movement has become {fall:.0%} smaller over {len(sessions)} sessions."
        advice = (
            "Ask about strength and pain. When it stays, calibrate again, so that full scale is what the person "
            "can do now; the range of motion is worth a note in the record."
        )
    elif len(here) >= LEAST_TRIALS and _goes(here, "falls"):
        first, last = float(np.median(here[:EDGE])), float(np.median(here[-EDGE:]))
        if last >= (1 - SPAN_FALL_WITHIN) * first:
            return []
        words = f"{label}: the movement has become {1 - last / first:.0%} smaller within this session."
        advice = "The person may be tired: let them rest, or end the session. Do not calibrate on a tired movement."
    else:
        return []
    return [ControlWarning(kind="span", joint=label, words=words, advice=advice)]


def _note(trials: Sequence[JudgedTrial]) -> str:
    """Say what cannot be told yet."""
    sessions = len({trial.session for trial in trials})
    here = sum(trial.session == trials[-1].session for trial in trials)
    if sessions >= LEAST_SESSIONS or here >= LEAST_TRIALS:
        return ""
    return (
        f"Few trials: whether movements get smaller is told from {LEAST_TRIALS} trials in one session or from "
        f"{LEAST_SESSIONS} sessions on; here are {here} in this session, and {sessions} "
        f"{'session' if sessions == 1 else 'sessions'}."
    )


def _rows(trials: Iterable[JudgedTrial], name: str) -> list[_Row]:
    return [_Row(trial, joint) for trial in trials for joint in trial.quality.joints if joint.name == name]


def _comparable(rows: Sequence[_Row]) -> list[_Row]:
    """Return those whose map reads the same channels as the last one's: only their signal units are the same."""
    return [row for row in rows if set(row.joint.channels) == set(rows[-1].joint.channels)]


def _direction(row: _Row) -> dict[str, float]:
    return row.joint.direction or {}


def _vector(row: _Row, channels: list[str]) -> NDArray[np.float64]:
    return np.array([_direction(row)[channel] for channel in channels])


def _unit(row: _Row) -> float:
    """Return how many signal units a full scale of this trial's map is."""
    return (row.joint.span or 0.0) / row.joint.span_share if row.joint.span_share else 0.0


def _median(rows: Sequence[_Row], name: str) -> float:
    return float(np.median([getattr(row.joint, name) for row in rows]))


def _per_metre(trials: Sequence[JudgedTrial]) -> list[float]:
    known = (trial.quality.activations_per_metre for trial in trials)
    return [value for value in known if value is not None]


def _goes(values: Sequence[float], direction: Literal["falls", "rises"]) -> bool:
    trend = mann_kendall(values)
    return trend.p < SIGNIFICANCE and trend.direction == direction
