"""What the flows ask of a recording; app/session/recordings.py answers from disk, tests answer without one."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.adaptation.proposal import Proposal
from app.calibration.profile import CalibrationProfile
from app.calibration.script import Step
from app.calibration.vocabulary import DriveParameters
from app.layout import ShirtLayout
from app.scoring.control_quality import ControlQuality
from app.scoring.trial_forecast import Effect
from app.world.floorplan import FloorPlan, PrescribedPath


class Driven(NamedTuple):
    """Where the chair was while motion was permitted, from then on."""

    t: NDArray[np.float64]  # (n,) s
    x: NDArray[np.float64]  # (n,) m
    y: NDArray[np.float64]


class Adapted(NamedTuple):
    """What the last trials would change of a set, and what the last of them would have been like with it."""

    proposal: Proposal
    effect: Effect | None  # None where nothing would change, or it cannot be replayed


Judge = Callable[[Path, float], str | None]
"""Recording and duration (s) of a step: in one sentence why it does not do, None when it does."""
Fit = Callable[[ShirtLayout, list[tuple[Step, Path]], list[str]], CalibrationProfile]
"""Layout, each step with its recording, unused channels: the profile; ValueError with a sentence."""
Measure = Callable[[Path, FloorPlan, PrescribedPath], dict[str, Any]]
"""Recording of a trial, where it was driven and what was asked: all measures; ValueError when nothing was driven."""
Quality = Callable[[Path], ControlQuality]
"""Recording of a trial: how well the map fitted it; ValueError or OSError when that cannot be told."""
Drive = Callable[[Path], Driven]
"""Recording of a trial: where the chair went; ValueError or OSError when it cannot be read."""
Adapt = Callable[[DriveParameters, CalibrationProfile, list[Path], int, Callable[[], bool]], Adapted | None]
"""The set that drives, the calibration that it goes back to, recordings of trials (the newest last), how many of them
were driven with its map, and whether to leave off: what they would change; None when it was left off."""


@dataclass(frozen=True, slots=True)
class Readings:
    """The six questions."""

    judge: Judge
    fit: Fit
    measure: Measure
    drive: Drive
    quality: Quality
    adapt: Adapt
