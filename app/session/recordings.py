"""Read from recordings what calibration and scoring need. Figures never come from the live picture."""

from collections.abc import Collection
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.adaptation.donning_fit import fit_to_donning
from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.fit.repetitions import Repetition, Stretch, repetitions_of_run, stretch_of_run
from app.calibration.guided.guided_map import with_guided_maps
from app.calibration.prior.documents import PersonEntry
from app.calibration.prior.entry import person_entry
from app.calibration.prior.map_prior import MapPrior
from app.calibration.prior.prior_map import with_best_maps, with_prior_maps
from app.calibration.profile import CalibrationProfile
from app.calibration.script import Step
from app.calibration.vocabulary import DriveParameters
from app.faults import State
from app.json_values import JsonDocument
from app.layout import ShirtLayout
from app.recording.format import Columns
from app.recording.reader import read_run
from app.recording.recorded_trajectory import since_armed
from app.scoring.control_quality import ControlQuality, control_quality
from app.scoring.task_measures import task_measures
from app.session.calibration.step_check import advice_of, check_frames
from app.texts import Text, text_of
from app.world.floorplan import FloorPlan, PrescribedPath

MEASURES_VERSION = 2  # measures of an older version are computed again


def check_recording(folder: Path, duration: float) -> Text | str | None:
    """Return in one sentence why a step's recording cannot be used, None when it can."""
    run = read_run(folder)
    if run.damage:
        return str(run.damage)
    if run.dropped:
        return Text("visit-ticks-lost", count=run.dropped)
    return check_frames(run.frames()["run_t"], duration, float(run.meta["sample_rate"]))


class StepPieces(NamedTuple):
    """What was recorded in the steps of a calibration."""

    sample_rate: float  # Hz
    free: NDArray[np.floating]  # (n, n_channels)
    rest: NDArray[np.floating] | None
    repetitions: list[Repetition]
    stretches: list[Stretch]

    def clean(self, layout: ShirtLayout, unused: Collection[str]) -> CleanRecording:
        """Return them made ready for the fits; raise ValueError with a sentence when they cannot be."""
        return CleanRecording.of(
            layout, self.sample_rate, self.free, self.rest, self.repetitions, self.stretches, unused
        )


def fit_recordings(
    layout: ShirtLayout,
    recorded: list[tuple[Step, Path]],
    unused: list[str],
    prior: MapPrior | None,
    as_worn: tuple[str, ...] = (),
) -> CalibrationProfile:
    """Fit the profile from the recordings of all steps; raise ValueError with a sentence when it cannot be fitted.

    A joint whose prompts allow it carries a guided map beside that of the paper, for the clinician to choose. With a
    `prior` it carries the map learnt from other people, too, and the best one of the three decodes: a prompted joint's
    held-out repetitions decide (`JointMap.best_map`), a joint that was not prompted drives by other people.
    The rings `as_worn` sit right, however they look.
    """
    recording = _pieces(recorded).clean(layout, unused)
    profile = with_guided_maps(fit_profile(recording), recording).profile
    if prior is None:
        return profile
    return with_best_maps(with_prior_maps(profile, prior, recording, as_worn).profile)


def judge_step(
    layout: ShirtLayout, recorded: list[tuple[Step, Path]], unused: list[str], step: Step
) -> Text | str | None:
    """Return why a step has to be repeated, in the words of the result; None when it need not be.

    It is fitted with the rest and the free movement alone; nothing is said before both are recorded.
    """
    kinds = {other.kind for other, _ in recorded}
    if step.kind == "rest" or not {"rest", "free"} <= kinds:
        return None
    pieces = _pieces([(other, folder) for other, folder in recorded if other.kind != "prompt" or other.id == step.id])
    try:
        profile = fit_profile(pieces.clean(layout, unused))
    except ValueError as error:
        return text_of(error)
    return advice_of(profile, step)


def fit_recordings_to_donning(
    parameters: DriveParameters,
    calibrated: CalibrationProfile,
    recorded: list[tuple[Step, Path]],
    prior: MapPrior | None,
) -> DriveParameters:
    """Return the parameters for the shirt as it sits in the recorded free movement; ValueError when they cannot be."""
    pieces = _pieces([(step, folder) for step, folder in recorded if step.kind == "free"])
    return fit_to_donning(parameters, calibrated, pieces.free, pieces.sample_rate, prior)


def entry_of_recordings(layout: ShirtLayout, recorded: list[tuple[Step, Path]]) -> PersonEntry:
    """Return what the recorded steps add to a prior; raise ValueError with a sentence when it is nothing."""
    pieces = _pieces(recorded)
    return person_entry([CleanRecording.of(layout, pieces.sample_rate, pieces.free, stretches=pieces.stretches)])


def _pieces(recorded: list[tuple[Step, Path]]) -> StepPieces:
    free: list[NDArray[np.floating]] = []
    rest: list[NDArray[np.floating]] = []
    repetitions: list[Repetition] = []
    stretches: list[Stretch] = []
    sample_rate = 0.0
    for step, folder in recorded:
        run = read_run(folder)
        frames = run.frames()
        sample_rate = float(run.meta["sample_rate"])
        if step.kind == "prompt":
            repetitions += repetitions_of_run(frames["values"], frames["cue"], step.cues, sample_rate)
            stretch = stretch_of_run(frames["values"], frames["cue"], step.cues)
            stretches += [stretch] if stretch else []
        elif step.kind == "rest":
            rest.append(_during(frames, step, "rest"))
        else:
            free.append(_during(frames, step, "free"))
    resting = np.concatenate(rest) if rest else None
    return StepPieces(sample_rate, np.concatenate(free), resting, repetitions, stretches)


def _during(frames: Columns, step: Step, kind: str) -> NDArray[np.floating]:
    """Return the values (n, n_channels) while a cue of this kind was shown."""
    cues = [index for index, cue in enumerate(step.cues) if cue.kind == kind]
    chosen: NDArray[np.floating] = frames["values"][np.isin(frames["cue"], cues)]
    return chosen


def measure_recording(folder: Path, plan: FloorPlan, path: PrescribedPath) -> JsonDocument:
    """Return all measures of a trial, from when motion was first permitted; ValueError when it never was.

    The time in which motion was not permitted any more is left out, and counted by its reason.
    """
    rows = since_armed(read_run(folder).columns)
    measures = task_measures(plan, path, {**rows, "t": rows["t"] - rows["t"][0], "v": rows["driven_v"]})
    return {**measures, "measures_version": MEASURES_VERSION}


def measure_again(folder: Path) -> JsonDocument:
    """Return the measures of a trial by its recording alone; ValueError when it does not hold the plan and the path."""
    meta = read_run(folder, ["t"]).meta
    if not meta.get("floorplan"):
        raise ValueError(Text("visit-recording-without-plan"))
    plan = FloorPlan.model_validate(meta["floorplan"])
    return measure_recording(folder, plan, plan.path_named(meta["path"]))


def quality_of_recording(folder: Path) -> ControlQuality:
    """Return how well the map of a trial fitted it; ValueError when the recording does not name its parameters."""
    run = read_run(folder)
    if not run.meta.get("parameters"):
        raise ValueError(Text("visit-recording-without-parameters"))
    rows = run.frames()
    line = since_armed(run.columns)
    return control_quality(
        DriveParameters.model_validate(run.meta["parameters"]),
        float(run.meta["sample_rate"]),
        rows["values"],
        rows["state"] == State.ARMED,
        rows["activation"],
        float(np.hypot(np.diff(line["x"]), np.diff(line["y"])).sum()),
    )
