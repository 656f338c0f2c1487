"""Warnings of noise that is large or grows, and of a movement that becomes smaller."""

from collections.abc import Sequence
from itertools import groupby
from typing import Literal

import numpy as np

from app.number_words import percent
from app.scoring.trend import mann_kendall
from app.scoring.trial_assessment import EDGE, FEWEST, ControlWarning, JointInTrial, median_of

# Share of the dead-zone: noise of a third of the dead-zone activates a gesture by chance about once a minute.
NOISE_SHARE = 1.0 / 3.0
NOISE_GROWTH = 1.5  # ratio to the first trials' noise; between sessions, constant noise differs by a factor of 1.2
SPAN_FALL = 0.08  # share of the first session's span: a loss of 2 % a session over five sessions
SPAN_FALL_WITHIN = 0.15  # share of the session's first trials' span; smaller strokes on purpose make a smaller fall
LEAST_TRIALS = 8  # of one session, for a trend within it, as for a learning curve
LEAST_SESSIONS = 5  # for a trend over sessions; four values rise or fall throughout by chance once in twelve times
SIGNIFICANCE = 0.05


def noise_warnings(of_map: Sequence[JointInTrial], every: Sequence[JointInTrial]) -> list[ControlWarning]:
    """Warn when a joint's noise at rest is near its dead-zone, or has grown."""
    known = [row for row in of_map if row.joint.rest_rate is not None]
    if len(known) >= FEWEST and known[-1].joint.dead_zone is not None:
        now, dead_zone, label = median_of(known[-EDGE:], "rest_rate"), known[-1].joint.dead_zone, known[-1].joint.label
        if now > NOISE_SHARE * dead_zone:
            return [
                ControlWarning(
                    kind="noise",
                    joint=label,
                    words=f"{label}: at rest it trembles with {percent(now)} / s of the full movement, and it counts "
                    f"from {percent(dead_zone)} / s, so that it may act by itself: let it count from "
                    f"{percent(4 * now)} / s.",
                    advice="Look for tremor, a tired patient or a loose plug. Then raise its “Counts from” in "
                    "Controls, or lower “Tremor damping”: lower damps more.",
                )
            ]
    rows = [row for row in every if row.joint.rest_rate is not None]
    if len(rows) < LEAST_TRIALS:
        return []
    values = [float(row.joint.rest_rate or 0.0) * _unit(row) for row in rows]
    first, last = float(np.median(values[:EDGE])), float(np.median(values[-EDGE:]))
    if first <= 0 or last < NOISE_GROWTH * first or not _has_trend(values, "rises"):
        return []
    label = rows[-1].joint.label
    return [
        ControlWarning(
            kind="noise",
            joint=label,
            words=f"{label}: the noise at rest has grown to {last / first:.1f} times that of the first trials.",
            advice="Look for tremor, a tired patient or a loose plug on the Shirt page. When it stays, repeat the step "
            "Rest of the calibration, so that the movement counts only above the noise.",
        )
    ]


def span_warnings(every: Sequence[JointInTrial]) -> list[ControlWarning]:
    """Warn when a joint's movement becomes smaller on one task, over sessions or within the last session.

    No warning when the person also needs fewer and fewer movements per metre: that is skill and no loss.
    """
    rows = [row for row in every if row.joint.span]
    if not rows or _has_trend(_per_metre(rows), "falls"):
        return []
    label = rows[-1].joint.label
    sessions = [
        float(np.median([float(row.joint.span or 0.0) for row in group]))
        for _, group in groupby(rows, key=lambda row: row.trial.session)
    ]
    here = [float(row.joint.span or 0.0) for row in rows if row.trial.session == rows[-1].trial.session]
    has_fallen = len(sessions) >= LEAST_SESSIONS and sessions[-1] < (1 - SPAN_FALL) * sessions[0]
    if has_fallen and _has_trend(sessions, "falls"):
        fall = 1 - sessions[-1] / sessions[0]
        words = f"{label}: the movement has become {percent(fall)} smaller over {len(sessions)} sessions."
        advice = (
            "Ask about strength and pain. When it stays, calibrate again, so that “Full at” is what the person can "
            "reach now, and note the range of motion in the record."
        )
    elif len(here) >= LEAST_TRIALS and _has_trend(here, "falls"):
        first, last = float(np.median(here[:EDGE])), float(np.median(here[-EDGE:]))
        if last >= (1 - SPAN_FALL_WITHIN) * first:
            return []
        words = f"{label}: the movement has become {percent(1 - last / first)} smaller within this session."
        advice = "The person may be tired: let them rest, or end the session. Do not calibrate on a tired movement."
    else:
        return []
    return [ControlWarning(kind="span", joint=label, words=words, advice=advice)]


def _unit(row: JointInTrial) -> float:
    """Return the full scale of the trial's map in signal units; 0 when unknown."""
    return (row.joint.span or 0.0) / row.joint.span_share if row.joint.span_share else 0.0


def _per_metre(rows: Sequence[JointInTrial]) -> list[float]:
    known = (row.trial.quality.activations_per_metre for row in rows)
    return [value for value in known if value is not None]


def _has_trend(values: Sequence[float], direction: Literal["falls", "rises"]) -> bool:
    trend = mann_kendall(values)
    return trend.p < SIGNIFICANCE and trend.direction == direction
