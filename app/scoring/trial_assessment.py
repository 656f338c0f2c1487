"""Trials with how well they were controlled, joint by joint: what the warnings are made from, and made of."""

from collections.abc import Iterable, Sequence
from typing import Literal, NamedTuple

import numpy as np

from app.quantities import Document
from app.scoring.control_quality import ControlQuality
from app.scoring.joint_quality import JointQuality

EDGE = 3  # trials at either end whose median stands for "at first" and "now"
FEWEST = 2  # trials that must agree before anything but a sensor is warned of

Kind = Literal["sensor", "map", "noise", "span"]


class TrialAssessment(NamedTuple):
    """A trial that counts, with how well it was controlled."""

    id: int
    number: int
    session: int  # 1, 2, 3 ... of the patient's sessions
    map_version: int
    task: str  # floor plan and path: how far a movement goes is compared on one task only
    quality: ControlQuality


class ControlWarning(Document):
    """One thing to look at."""

    kind: Kind
    joint: str  # what people call it
    words: str  # what was seen
    advice: str  # what to do


class JointInTrial(NamedTuple):
    """One joint in one trial."""

    trial: TrialAssessment
    joint: JointQuality


def trials_of_joint(trials: Iterable[TrialAssessment], name: str) -> list[JointInTrial]:
    """Return one joint of the trials that have it, in their order."""
    return [JointInTrial(trial, joint) for trial in trials for joint in trial.quality.joints if joint.name == name]


def comparable_trials(rows: Sequence[JointInTrial]) -> list[JointInTrial]:
    """Return those whose map reads the same channels as the last one's: only their signal units are the same."""
    return [row for row in rows if set(row.joint.channels) == set(rows[-1].joint.channels)]


def median_of(rows: Sequence[JointInTrial], name: str) -> float:
    """Return the median of one of the joint's figures, which each row must have."""
    return float(np.median([getattr(row.joint, name) for row in rows]))
