"""Trials with their control quality, from which the warnings of control are made."""

from collections.abc import Iterable, Sequence
from typing import Literal, NamedTuple

import numpy as np

from app.quantities import Document
from app.scoring.control_quality import ControlQuality
from app.scoring.joint_quality import JointQuality
from app.texts import Text

EDGE = 3  # trials at either end whose medians are compared
FEWEST = 2  # trials that a warning needs; a warning of a sensor needs one

Kind = Literal["sensor", "map", "noise", "span"]


class TrialAssessment(NamedTuple):
    """A trial that was not discarded, with its control quality."""

    id: int
    number: int
    session: int  # 1, 2, 3 ... of the patient's sessions
    map_version: int
    task: str  # floor plan and path; spans of movement are compared within one task only
    quality: ControlQuality


class ControlWarning(Document):
    """A warning from a patient's trials, with advice."""

    kind: Kind
    joint: Text  # what the joint is called, or several are
    message: Text  # what was found
    advice: Text  # what to do


class JointInTrial(NamedTuple):
    """One joint in one trial."""

    trial: TrialAssessment
    joint: JointQuality


def trials_of_joint(trials: Iterable[TrialAssessment], name: str) -> list[JointInTrial]:
    """Return one joint's qualities in the trials that have this joint, in the trials' order."""
    return [JointInTrial(trial, joint) for trial in trials for joint in trial.quality.joints if joint.name == name]


def comparable_trials(rows: Sequence[JointInTrial]) -> list[JointInTrial]:
    """Return the rows whose map reads the same channels as the last row's: only their signal units are comparable."""
    return [row for row in rows if set(row.joint.channels) == set(rows[-1].joint.channels)]


def median_of(rows: Sequence[JointInTrial], name: str) -> float:
    """Return the median of the joint's figure `name`, which must not be None in any row."""
    return float(np.median([getattr(row.joint, name) for row in rows]))
