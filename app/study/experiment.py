"""The paper's experiment without a screen: calibrate once, then drive the same path again and again."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from app.calibration.vocabulary import DriveParameters, standard_parameters
from app.hardware.body.person import Person
from app.hardware.body.person_parameters import NOVICE, PersonParameters
from app.layout import ShirtLayout
from app.scoring.learning import learning_curves
from app.settings import data_folder
from app.signals.signals import read_layout
from app.study.participant import Participant
from app.study.simulated_calibration import calibrate
from app.study.simulated_trial import StudyTrial, drive_trial
from app.world.floorplan import FloorPlan, PrescribedPath

SAMPLE_RATE = 100.0  # Hz
SHIRT = "bodydrive-52.json"
SEEDS_APART = 1_000_003  # the fabric's seed is another one than the person's

Progress = Callable[[StudyTrial], None]


@dataclass(frozen=True, slots=True)
class StudyResult:
    """What was asked and what came of it."""

    seed: int
    floorplan: FloorPlan
    path: PrescribedPath
    person: PersonParameters
    sample_rate: float  # Hz
    parameters: DriveParameters
    trials: tuple[StudyTrial, ...]
    learning: dict[str, dict[str, Any]]


def run_study(
    trials: int,
    seed: int,
    floorplan: FloorPlan,
    path_name: str,
    progress: Progress | None = None,
    person: PersonParameters = NOVICE,
) -> StudyResult:
    """Let a simulated person in the simulated shirt calibrate, then drive one path `trials` times.

    Everything between the body and the chair is what the application uses: the fabric, the calibration's script and
    fit, the chain with its gate, the scoring. The same seed gives the same numbers, bit for bit.

    Parameters
    ----------
    trials
        At least 1.
    seed
        Of the person and of the fabric.
    floorplan, path_name
        Where to drive; `path_name` is one of the plan's paths.
    progress
        Called with each trial when it is scored.
    person
        Who drives; a novice unless told otherwise. Learning is in the person, never in the scoring.

    Raises
    ------
    ValueError
        When the path is not in the plan, or the calibration could not be made.
    """
    path = floorplan.path_named(path_name)
    layout = shirt_layout()
    participant = Participant(Person(person, seed), layout, SAMPLE_RATE, seed + SEEDS_APART)
    parameters = standard_parameters(calibrate(participant))
    driven = []
    for number in range(1, trials + 1):
        trial = drive_trial(number, participant, parameters, floorplan, path)
        driven.append(trial)
        if progress is not None:
            progress(trial)
    curves = learning_curves([{"trial": trial.number, **trial.measures} for trial in driven])
    return StudyResult(seed, floorplan, path, person, SAMPLE_RATE, parameters, tuple(driven), curves)


def shirt_layout() -> ShirtLayout:
    """Return the layout of the simulated shirt: the paper's 52 channels."""
    return read_layout(data_folder() / "shirts" / SHIRT)
