"""Simulated people over sessions, and their trials' warnings. As a program: the table of docs/learning/quality.md.

`python tests/scoring/warning_cases.py --seeds 20`, or with `--only turned` one of the conditions.
"""

import argparse
import math
import pickle
import sys
from collections import Counter
from typing import NamedTuple

import numpy as np

from app.calibration.vocabulary import DriveParameters, standard_parameters
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.person_parameters import DETERIORATING, IMPROVING, NOVICE, PRACTISED, PersonParameters
from app.messages import SensorFrame
from app.pipeline.replay.batch import decode_block
from app.scoring.control_quality import control_quality
from app.scoring.control_warnings import control_warnings
from app.scoring.trial_assessment import ControlWarning, TrialAssessment
from app.study.experiment import SEEDS_APART, shirt_layout
from app.study.participant import Participant
from app.study.simulated_calibration import SAMPLE_RATE, calibrate
from app.study.simulated_trial import drive_trial
from app.world.scene import find_place

PLACE, PATH = "apartment", "main"  # 13.6 m with two corners


class Condition(NamedTuple):
    """A simulated person, and what happens to the shirt or the map."""

    person: PersonParameters
    sessions: int = 8
    trials: int = 3
    turned: int | None = None  # session from which the fabric's directions are others, with unchanged offsets
    donned_again: int | None = None  # session before which the shirt is put on again
    calibrated_again: bool = False  # put the shirt on and calibrate before each session
    dies: int | None = None  # session in whose second trial a channel becomes constant


CONDITIONS = {
    "steady": Condition(PRACTISED),
    "steady, calibrated each session": Condition(PRACTISED, calibrated_again=True),
    "novice": Condition(NOVICE),
    "improving": Condition(IMPROVING),
    "deteriorating": Condition(DETERIORATING),
    "tired limbs": Condition(PersonParameters(practice=1500.0, range_per_session=-0.02)),
    "turned": Condition(PRACTISED, sessions=2, turned=2),
    "worn again": Condition(PRACTISED, sessions=2, trials=2, donned_again=2),
    "channel dies": Condition(PRACTISED, sessions=2, trials=2, dies=2),
}


class RecordedParticipant(Participant):
    """A participant whose frames are kept, and one of whose channels may be made constant."""

    def __init__(self, person: SimulatedPerson, seed: int) -> None:
        super().__init__(person, shirt_layout(), SAMPLE_RATE, seed)
        self.frames: list[np.ndarray] = []
        self.dead: int | None = None

    def _frame(self) -> SensorFrame:
        frame = super()._frame()
        if self.dead is not None:
            frame.values[self.dead] = 1.5
        self.frames.append(frame.values.copy())
        return frame


def sessions_of(condition: Condition, seed: int, place: str = PLACE, path_name: str = PATH) -> list[TrialAssessment]:
    """Drive all sessions of one person, and return the trials in the order driven."""
    plan = find_place(place)
    assert plan is not None
    path = plan.path_named(path_name)
    participant = RecordedParticipant(SimulatedPerson(condition.person, seed), seed + SEEDS_APART)
    parameters, version = standard_parameters(calibrate(participant)), 1
    trials: list[TrialAssessment] = []
    for session in range(1, condition.sessions + 1):
        participant.person.begin_session(session)
        if session == condition.turned:
            offsets = participant._fabric._offsets
            participant._fabric.don_again()
            participant._fabric._offsets = offsets
        if session == condition.donned_again or (condition.calibrated_again and session > 1):
            participant._fabric.don_again()
        if condition.calibrated_again and session > 1:
            parameters, version = standard_parameters(calibrate(participant)), version + 1
        for number in range(1, condition.trials + 1):
            if session == condition.dies and number == 2:
                participant.dead = np.random.default_rng(seed).choice(_used(parameters))
            participant.frames.clear()
            driven = drive_trial(len(trials) + 1, participant, parameters, plan, path).columns
            values = np.array(participant.frames)
            t = np.arange(len(values)) / SAMPLE_RATE
            armed = np.arange(len(values)) >= len(values) - len(driven["t"])
            activation = decode_block(parameters, SAMPLE_RATE, t, values).activation
            way = float(np.hypot(np.diff(driven["x"]), np.diff(driven["y"])).sum())
            quality = control_quality(parameters, SAMPLE_RATE, values, armed, activation, way)
            trials.append(TrialAssessment(len(trials) + 1, len(trials) + 1, session, version, path_name, quality))
    return trials


def _used(parameters: DriveParameters) -> list[int]:
    bound = {name for binding in parameters.bindings for name in binding.gestures}
    return [channel for joint in parameters.profile.joints if joint.name in bound for channel in joint.channels]


def warnings_by_session(trials: list[TrialAssessment]) -> dict[int, list[ControlWarning]]:
    """Return the warnings that a clinician would have seen after each session."""
    said = {}
    for session in sorted({trial.session for trial in trials}):
        said[session] = control_warnings([trial for trial in trials if trial.session <= session]).warnings
    return said


def row(name: str, found: list[dict[int, list[ControlWarning]]]) -> str:
    """Return one row of the table: people without a warning, and by kind those with one and its first session."""
    counts: Counter[str] = Counter()
    first: dict[str, list[int]] = {}
    for said in found:
        kinds = {
            kind: min(s for s, all_ in said.items() if any(w.kind == kind for w in all_))
            for kind in {w.kind for all_ in said.values() for w in all_}
        }
        for kind, session in kinds.items():
            counts[kind] += 1
            first.setdefault(kind, []).append(session)
    silent = sum(not any(said.values()) for said in found)
    cells = [
        f"{counts[kind]} (from session {_middle(first[kind])})" if counts[kind] else "0"
        for kind in ("sensor", "map", "noise", "span")
    ]
    return f"| {name} | {len(found)} | {silent} | {' | '.join(cells)} |"


def _middle(sessions: list[int]) -> str:
    return f"{sorted(sessions)[math.ceil(len(sessions) / 2) - 1]}"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--only", choices=list(CONDITIONS))
    parser.add_argument("--keep", help="a file that takes the trials, for a closer look")
    given = parser.parse_args()
    kept = {}
    say = sys.stdout.write
    say("| person | seeds | never warned | sensor | map | noise | span |\n|---|---|---|---|---|---|---|\n")
    for name, condition in CONDITIONS.items():
        if given.only in (None, name):
            kept[name] = [sessions_of(condition, seed) for seed in range(1, given.seeds + 1)]
            say(row(name, [warnings_by_session(trials) for trials in kept[name]]) + "\n")
            sys.stdout.flush()
            if given.keep:
                with open(f"{given.keep}-{name}.pickle", "wb") as file:
                    pickle.dump(kept[name], file)


if __name__ == "__main__":
    main()
