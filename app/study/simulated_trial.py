"""One trial of a study: armed after the neutral check, driven through the chain, scored as any trial."""

from dataclasses import dataclass
from operator import attrgetter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.vocabulary import DriveParameters
from app.faults import State
from app.geometry import Pose
from app.hardware.chair.simulator import VirtualChair
from app.pipeline.chain import Chain
from app.pipeline.safety_gate import Conditions
from app.scoring.measures import MeasureValues
from app.scoring.task_measures import task_measures
from app.study.participant import Participant
from app.world.floorplan import FloorPlan, PrescribedPath
from app.world.progress import leader_of, progress_of

REST_BEFORE = 2.0  # s at rest before a trial, so that the filters forget the last trial's strokes
CLEAR_AFTER = 2.0  # s from a latched fault until a clinician would clear it and arm again
LONGEST_WAIT = 30.0  # s until motion is permitted; after that the trial is given up
COLUMNS = ("t", "x", "y", "theta", "v", "omega", "u1", "u2", "in_contact", "contacts", "scene_t")

Numbers = NDArray[np.float64]
_row = attrgetter(*COLUMNS)
FrameLog = list[tuple[NDArray[np.float32], bool]]
"""Frames (n_channels,), each with whether motion was permitted."""


class DrivenTrial(NamedTuple):
    """One attempt along the path, not yet scored."""

    number: int  # from 1
    faults: int  # latched stops on the way
    columns: dict[str, Numbers]  # (n,) each, by the names in COLUMNS; t in s since motion was permitted


@dataclass(frozen=True, slots=True)
class StudyTrial:
    """One attempt along the path, scored."""

    number: int  # from 1
    measures: MeasureValues
    faults: int  # latched stops on the way
    t: Numbers  # (n,) s since motion was permitted
    x: Numbers  # (n,) m
    y: Numbers
    theta: Numbers  # rad
    v: Numbers  # m/s
    omega: Numbers  # rad/s


def drive_trial(
    number: int,
    participant: Participant,
    parameters: DriveParameters,
    floorplan: FloorPlan,
    path: PrescribedPath,
    frames: FrameLog | None = None,
) -> DrivenTrial:
    """Drive the path once, until the goal or the path's time limit.

    All frames from the rest before the trial on are appended to `frames`.
    """
    chair = VirtualChair(floorplan, path.start)
    chain = Chain(participant.sample_rate, parameters, chair)
    participant.person.show_task(floorplan, path)
    conditions = Conditions()
    frames = [] if frames is None else frames
    _settle(participant, chain, conditions, frames)
    rows, faults = _drive(participant, chain, chair, conditions, floorplan, path, frames)
    columns = dict(zip(COLUMNS, np.array(rows, dtype=np.float64).T, strict=True))
    columns["t"] = columns["t"] - columns["t"][0]
    return DrivenTrial(number, faults, columns)


def score_trial(floorplan: FloorPlan, path: PrescribedPath, driven: DrivenTrial) -> StudyTrial:
    """Return a trial with its measures."""
    number, faults, columns = driven
    trajectory = (columns[name] for name in ("t", "x", "y", "theta", "v", "omega"))
    return StudyTrial(number, task_measures(floorplan, path, columns), faults, *trajectory)


def _settle(participant: Participant, chain: Chain, conditions: Conditions, frames: FrameLog) -> None:
    """Let the participant rest for 2 s, disarmed."""
    for _ in range(round(REST_BEFORE * participant.sample_rate)):
        frame = participant.rest()
        chain.step(frame, frame.t, conditions)
        frames.append((frame.values, False))


def _drive(
    participant: Participant,
    chain: Chain,
    chair: VirtualChair,
    conditions: Conditions,
    floorplan: FloorPlan,
    path: PrescribedPath,
    frames: FrameLog,
) -> tuple[list[tuple[float, ...]], int]:
    """Return one row per tick since motion was permitted, and the number of latched faults."""
    progress, leader = progress_of(floorplan, path), leader_of(floorplan, path)
    rows: list[tuple[float, ...]] = []
    faults = 0
    clear_at = 0.0
    chain.arm()
    frame = participant.rest()
    tick = chain.step(frame, frame.t, conditions)
    deadline = frame.t + min(LONGEST_WAIT, path.time_limit)
    while frame.t < deadline:
        if tick.state is State.FAULT and clear_at == 0.0:
            faults += 1
            clear_at = frame.t + CLEAR_AFTER
        elif tick.state is State.FAULT and frame.t >= clear_at:
            chain.gate.clear(chain.gate.stops)
            chain.arm()
            clear_at = 0.0
        ahead = None if leader is None else leader.at(chair.state.scene_t)
        frame = participant.drive(tick.state is State.ARMED, chair.state, ahead)
        tick = chain.step(frame, frame.t, conditions)
        frames.append((frame.values, tick.state is State.ARMED))
        if not rows and tick.state is State.ARMED:
            deadline = frame.t + path.time_limit
        if rows or tick.state is State.ARMED:
            rows.append(_row(tick))
            progress.update(Pose(tick.x, tick.y, tick.theta), chair.state.v, tick.scene_t)
            if progress.reached:
                break
    return rows or [_row(tick)], faults
