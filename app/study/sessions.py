"""The study over sessions: one calibration, then sessions of trials, with a fixed or an adapted map."""

import math
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from typing import TypeVar

import numpy as np

from app.calibration.adaptation.channel_range import shift_ranges
from app.calibration.adaptation.donning_range import fit_ranges
from app.calibration.adaptation.movement import Movement
from app.calibration.adaptation.proposal import propose
from app.calibration.adaptation.proposal_document import Proposal
from app.calibration.prior.map_prior import MapPrior
from app.calibration.prior.shipped import shipped_prior
from app.calibration.profile import CalibrationProfile
from app.calibration.script import calibration_script
from app.calibration.vocabulary import DriveParameters, standard_parameters
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.person_parameters import DETERIORATING, IMPROVING, PRACTISED, PersonParameters
from app.scoring.map_losses.losses import NOTHING_READ, PastTrial, losses_of, read_trials
from app.study.choices import Mode, PersonKind, StudyMap
from app.study.experiment import SEEDS_APART, shirt_layout
from app.study.participant import Participant
from app.study.simulated_calibration import GARMENT, SAMPLE_RATE, calibrate, calibrate_with_prior, record_step
from app.study.simulated_trial import FrameLog, StudyTrial, drive_trial, score_trial
from app.texts import Text
from app.world.floorplan import FloorPlan, PrescribedPath

Rows = TypeVar("Rows")

PERSONS: dict[PersonKind, PersonParameters] = {
    "steady": PRACTISED,
    "improving": IMPROVING,
    "deteriorating": DETERIORATING,
    "redonned": PRACTISED,  # only the position of the shirt changes from session to session
}


@dataclass(frozen=True, slots=True)
class StudySessionTrial:
    """One trial of one seed, and the adaptation of the map after it."""

    seed: int
    mode: Mode
    session: int  # from 1
    trial: int  # from 1, in its session
    e_diff: float  # m2
    dist: float  # m
    time: float  # s
    reached: bool
    faults: int
    proposed: int  # joints that would change, because their map loses something
    felt_change: float  # of the applied step; in mode `suggest`, of the proposed one
    angle_deg: float  # largest turn of a joint in that step
    flips: int  # joints whose direction that step reverses
    refused: int  # joints whose step was refused
    dead_zone: float  # FS/s, mean over the bound gestures, in this trial
    full: float  # FS/s, mean over the bound gestures, in this trial
    from_calibration_deg: float  # largest angle of a joint to its calibration, in this trial


@dataclass(frozen=True, slots=True)
class CalibratedParticipant:
    """A participant just after the calibration; each condition of the study begins with one, equal by its seed."""

    kind: PersonKind
    seed: int
    participant: Participant
    profile: CalibrationProfile


def calibrated_participant(kind: PersonKind, seed: int, map_kind: StudyMap = "pca") -> CalibratedParticipant:
    """Return a participant with this seed, with the profile of the calibration.

    For a map from other people the participant wears the simulated shirt that a prior ships for; for the others, a
    shirt of one's own.
    """
    if map_kind == "prior":
        participant = Participant(SimulatedPerson(PERSONS[kind], seed), shirt_layout(), SAMPLE_RATE, GARMENT)
        participant.wear(seed + SEEDS_APART)
        return CalibratedParticipant(kind, seed, participant, calibrate_with_prior(participant, _other_people()))
    participant = Participant(SimulatedPerson(PERSONS[kind], seed), shirt_layout(), SAMPLE_RATE, seed + SEEDS_APART)
    return CalibratedParticipant(kind, seed, participant, calibrate(participant, map_kind))


def run_sessions(
    mode: Mode,
    first: CalibratedParticipant,
    sessions: int,
    trials: int,
    floorplan: FloorPlan,
    path: PrescribedPath,
) -> list[StudySessionTrial]:
    """Drive `sessions` sessions of `trials` trials with one calibrated person, and return all trials.

    The person tires and learns: `first` cannot begin another condition afterwards.

    `redonned` puts the shirt on again before each session but the first. The channel ranges of safety rule S5 then
    follow ten seconds of free movement, otherwise sound channels would count as broken and the chair would not move: in
    mode `off` they are shifted, in the others fitted (`donning_range.py`). After each trial a change is proposed where
    the trials so far show that the present map loses something; mode `auto` applies it before the next trial.
    """
    participant, calibrated = first.participant, first.profile
    parameters = standard_parameters(calibrated)
    rows: list[StudySessionTrial] = []
    past, read = list[PastTrial](), NOTHING_READ
    for session in range(1, sessions + 1):
        parameters = begin_session(first, session, parameters, fitted=mode != "off")
        movements: list[Movement] = []
        for number in range(1, trials + 1):
            frames: FrameLog = []
            driven = drive_trial(number, participant, parameters, floorplan, path, frames)
            trial = score_trial(floorplan, path, driven)
            movements.append(_movement(frames))
            past.append(_past_trial(len(past), movements[-1], parameters))
            proposal = None
            if mode != "off":
                read = read_trials(parameters, past, read)
                losses = losses_of(parameters, calibrated, past, read)
                proposal = propose(parameters, movements, losses, calibrated=calibrated, fresh=1)
            rows.append(_row(mode, first, session, trial, parameters, proposal))
            if mode == "auto" and proposal is not None and proposal.parameters is not None:
                parameters = proposal.parameters
    return rows


def begin_session(
    first: CalibratedParticipant, session: int, parameters: DriveParameters, *, fitted: bool = False
) -> DriveParameters:
    """Bring the person to a session (from 1), and return the parameters with the channel ranges of that session.

    The ranges are shifted to the free movement of a shirt that was put on again, or `fitted` to it.
    """
    participant = first.participant
    participant.person.begin_session(session)
    if first.kind != "redonned" or session == 1:
        return parameters
    participant.don_again()
    free = _free_movement(participant)
    profile = parameters.profile
    profile = fit_ranges(profile, free, first.profile) if fitted else shift_ranges(profile, [free], first.profile)
    return parameters.model_copy(update={"profile": profile})


def each_seed(run: Callable[[int], Rows], seeds: Sequence[int], processes: int) -> Iterator[Rows]:
    """Yield the rows of one seed after the other, in the order of `seeds`; up to `processes` seeds run at once."""
    if processes == 1:
        yield from map(run, seeds)
        return
    with ProcessPoolExecutor(min(len(seeds), processes)) as pool:
        yield from pool.map(run, seeds)


def run_participants(
    kind: PersonKind,
    seeds: Sequence[int],
    modes: Sequence[Mode],
    sessions: int,
    trials: int,
    floorplan: FloorPlan,
    path: PrescribedPath,
    processes: int = 1,
    *,
    map_kind: StudyMap = "pca",
) -> Iterator[list[StudySessionTrial]]:
    """Return all trials of one seed after the other, in the order of `seeds`: its sessions in each of the modes.

    Up to `processes` seeds are driven at once; the results do not depend on their number.
    """
    run = partial(_run_participant, kind, modes, sessions, trials, floorplan, path, map_kind)
    return each_seed(run, seeds, processes)


def _run_participant(
    kind: PersonKind,
    modes: Sequence[Mode],
    sessions: int,
    trials: int,
    floorplan: FloorPlan,
    path: PrescribedPath,
    map_kind: StudyMap,
    seed: int,
) -> list[StudySessionTrial]:
    return [
        row
        for mode in modes
        for row in run_sessions(mode, calibrated_participant(kind, seed, map_kind), sessions, trials, floorplan, path)
    ]


def _other_people() -> MapPrior:
    shipped = shipped_prior(shirt_layout())
    if shipped is None:
        raise ValueError(Text("study-no-prior"))
    return MapPrior.of(shipped)


def _free_movement(participant: Participant) -> Movement:
    """Return the channels during ten seconds of free movement, as after putting the shirt on."""
    step = next(step for step in calibration_script(participant.layout) if step.kind == "free")
    values, _cue = record_step(participant, step)
    return Movement(values, participant.sample_rate, np.zeros(len(values), dtype=np.bool_))


def _movement(frames: FrameLog) -> Movement:
    values = np.array([frame for frame, _ in frames])
    return Movement(values, SAMPLE_RATE, np.array([permitted for _, permitted in frames], dtype=np.bool_))


def _past_trial(number: int, movement: Movement, parameters: DriveParameters) -> PastTrial:
    return PastTrial(str(number), lambda: movement, {gesture.name: gesture.full for gesture in parameters.gestures})


def _row(
    mode: Mode,
    first: CalibratedParticipant,
    session: int,
    trial: StudyTrial,
    parameters: DriveParameters,
    proposal: Proposal | None,
) -> StudySessionTrial:
    """Return the row of a trial that was driven with `parameters`, and of the step proposed after it."""
    measures, after = trial.measures, (proposal and proposal.parameters) or parameters
    gestures = [parameters.gestures[index] for index in parameters.bound_gestures]
    return StudySessionTrial(
        seed=first.seed,
        mode=mode,
        session=session,
        trial=trial.number,
        e_diff=measures["e_diff"],
        dist=measures["dist"],
        time=measures["time"],
        reached=bool(measures["reached"]),
        faults=trial.faults,
        proposed=sum(joint.status == "applied" for joint in proposal.joints) if proposal else 0,
        felt_change=proposal.felt_change if proposal else 0.0,
        angle_deg=max(_angles(parameters, after)) if proposal else 0.0,
        flips=sum(angle > 90.0 for angle in _angles(parameters, after)),
        refused=sum(joint.status == "refused" for joint in proposal.joints) if proposal else 0,
        dead_zone=float(np.mean([gesture.dead_zone for gesture in gestures])),
        full=float(np.mean([gesture.full for gesture in gestures])),
        from_calibration_deg=max(_angles(parameters, standard_parameters(first.profile))),
    )


def _angles(before: DriveParameters, after: DriveParameters) -> list[float]:
    """Return by what angle (degrees, 0 to 180) each joint's direction differs between two parameter sets.

    The half angle is that of the difference to the sum of the two unit vectors: exactly 0 for equal ones, where the
    angle of a rounded cosine is not.
    """
    angles = []
    for joint, joint_after in zip(before.profile.joints, after.profile.joints, strict=True):
        direction_before, direction_after = np.array(joint.direction), np.array(joint_after.direction)
        half = math.atan2(
            float(np.linalg.norm(direction_before - direction_after)),
            float(np.linalg.norm(direction_before + direction_after)),
        )
        angles.append(math.degrees(2.0 * half))
    return angles
