"""Warnings of noise that grows, and of a movement that gets smaller."""

from collections.abc import Sequence
from itertools import groupby
from typing import Literal

import numpy as np

from app.scoring.trend import mann_kendall
from app.scoring.trial_assessment import EDGE, FEWEST, ControlWarning, JointInTrial, median_of

# Of the dead-zone: with noise at a third of it, chance alone activates a gesture about once a minute.
NOISE_SHARE = 1.0 / 3.0
NOISE_GROWTH = 1.5  # times that of the first trials: between sessions, steady noise differs by 1.2 at most
SPAN_FALL = 0.08  # of the first session's: what a loss of 2 % a session comes to within five sessions
SPAN_FALL_WITHIN = 0.15  # of this session's first trials: strokes chosen a little smaller make less
LEAST_TRIALS = 8  # of one session, for a trend within it; the learning curves ask for as many
LEAST_SESSIONS = 5  # for a trend over sessions: four in one order are chance once in twelve times
SIGNIFICANCE = 0.05


def noise_warnings(of_map: Sequence[JointInTrial], every: Sequence[JointInTrial]) -> list[ControlWarning]:
    """Tell when a joint's noise at rest comes near its dead-zone, or has grown."""
    known = [row for row in of_map if row.joint.rest_rate is not None]
    if len(known) >= FEWEST and known[-1].joint.dead_zone is not None:
        now, dead_zone, label = median_of(known[-EDGE:], "rest_rate"), known[-1].joint.dead_zone, known[-1].joint.label
        if now > NOISE_SHARE * dead_zone:
            return [
                ControlWarning(
                    kind="noise",
                    joint=label,
                    words=f"{label}: at rest the noise is {now:.2f} FS/s, too near the dead-zone of "
                    f"{dead_zone:.2f} FS/s, so that the gesture may activate by itself: it needs {4 * now:.2f} FS/s.",
                    advice="Look for tremor, a tired patient or a loose plug. Then raise the dead-zone on the Controls "
                    "page, or lower the cutoff of the tremor damping.",
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


def span_warnings(every: Sequence[JointInTrial]) -> list[ControlWarning]:
    """Tell when a joint moves less and less on one task, over sessions or within the last one.

    Smaller movements that are also fewer for the same way are skill and no loss: then nothing is said.
    """
    rows = [row for row in every if row.joint.span]
    if not rows or _goes(_per_metre(rows), "falls"):
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


def _unit(row: JointInTrial) -> float:
    """Return how many signal units a full scale of this trial's map is."""
    return (row.joint.span or 0.0) / row.joint.span_share if row.joint.span_share else 0.0


def _per_metre(rows: Sequence[JointInTrial]) -> list[float]:
    known = (row.trial.quality.activations_per_metre for row in rows)
    return [value for value in known if value is not None]


def _goes(values: Sequence[float], direction: Literal["falls", "rises"]) -> bool:
    trend = mann_kendall(values)
    return trend.p < SIGNIFICANCE and trend.direction == direction
