"""The functions that a session calls to read recordings; app/session/recordings.py reads them from disk.

Tests pass functions of their own, which need no recording.
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.adaptation.proposal_document import Proposal
from app.calibration.profile import CalibrationProfile
from app.calibration.script import Step
from app.calibration.vocabulary import DriveParameters
from app.layout import ShirtLayout
from app.scoring.control_quality import ControlQuality
from app.scoring.trial_forecast import Effect
from app.world.floorplan import FloorPlan, PrescribedPath


class RecordedTrajectory(NamedTuple):
    """Where the chair was in a trial, from the moment when motion was first permitted."""

    t: NDArray[np.float64]  # (n,) s
    x: NDArray[np.float64]  # (n,) m
    y: NDArray[np.float64]


class AdaptationResult(NamedTuple):
    """The proposal to adapt a parameter set, and its predicted effect on the newest trial."""

    proposal: Proposal
    effect: Effect | None  # None when nothing would change, or the trial cannot be decoded again


CheckStep = Callable[[Path, float], str | None]
"""(recording, duration in s) of a step -> a sentence that says why it cannot be used, None when it can."""
Fit = Callable[[ShirtLayout, list[tuple[Step, Path]], list[str]], CalibrationProfile]
"""(layout, each step with its recording, unused channels) -> the profile; ValueError with a sentence."""
Measure = Callable[[Path, FloorPlan, PrescribedPath], dict[str, Any]]
"""(recording of a trial, floor plan, path) -> all measures; ValueError when motion was never permitted."""
Quality = Callable[[Path], ControlQuality]
"""(recording of a trial) -> how well its map fitted; ValueError or OSError when the recording does not tell."""
ReadTrajectory = Callable[[Path], RecordedTrajectory]
"""(recording of a trial) -> where the chair went; ValueError or OSError when it cannot be read."""
Adapt = Callable[[DriveParameters, CalibrationProfile, list[Path], int, Callable[[], bool]], AdaptationResult | None]
"""(parameters, calibrated profile, recordings, fresh, leave_off) -> the result; None when `leave_off` returned True.

`parameters` is the set that drives, the profile the calibration that its map goes back to. The recordings are of
trials, the newest last; the last `fresh` of them were driven with the map of `parameters`.
"""


@dataclass(frozen=True, slots=True)
class Readings:
    """The six functions that read recordings."""

    check_step: CheckStep
    fit: Fit
    measure: Measure
    trajectory: ReadTrajectory
    quality: Quality
    adapt: Adapt
