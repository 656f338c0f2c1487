"""The paper's experiment with a simulated person: calibrate once, then drive one path repeatedly."""

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor, Future
from dataclasses import dataclass

from app.calibration.vocabulary import DriveParameters, standard_parameters
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.person_parameters import NOVICE, PersonParameters
from app.layout import ShirtLayout
from app.scoring.learning import CurveDocument, learning_curves
from app.settings import data_folder
from app.signals.signals import read_layout
from app.study.participant import Participant
from app.study.second_process import SameProcess
from app.study.simulated_calibration import SAMPLE_RATE, fit_recorded, record_calibration
from app.study.simulated_trial import DrivenTrial, StudyTrial, drive_trial, score_trial
from app.world.floorplan import FloorPlan, PrescribedPath

SHIRT = "bodydrive-52.json"
SEEDS_APART = 1_000_003  # added to the person's seed, it is the fabric's

Progress = Callable[[StudyTrial], None]


@dataclass(frozen=True, slots=True)
class StudyResult:
    """The conditions of a study, its trials and its learning curves."""

    seed: int
    floorplan: FloorPlan
    path: PrescribedPath
    person: PersonParameters
    sample_rate: float  # Hz
    parameters: DriveParameters
    trials: tuple[StudyTrial, ...]
    learning: dict[str, CurveDocument]  # by measure


def run_study(
    trials: int,
    seed: int,
    floorplan: FloorPlan,
    path_name: str,
    progress: Progress | None = None,
    person: PersonParameters = NOVICE,
    second: Executor | None = None,
) -> StudyResult:
    """Let a simulated person in the simulated shirt calibrate, then drive one path `trials` times.

    The fabric, the calibration's script and fit, the chain with its gate, the virtual chair and the scoring are those
    of the application. Equal seeds give equal numbers, bit for bit.

    Parameters
    ----------
    trials
        At least 1.
    seed
        Of the person and of the fabric.
    floorplan, path_name
        The floor plan, and the name of one of its paths.
    progress
        Called with each trial when it is scored.
    person
        Parameters of the person; a novice by default. The person learns; the scoring knows nothing of learning.
    second
        What fits and scores; a trial is scored while the next one is driven. This process itself by default. The
        results do not depend on it.

    Raises
    ------
    ValueError
        When the path is not in the plan, or the calibration could not be made.
    """
    path = floorplan.path_named(path_name)
    layout = shirt_layout()
    participant = Participant(SimulatedPerson(person, seed), layout, SAMPLE_RATE, seed + SEEDS_APART)
    second = second or SameProcess()
    recorded = record_calibration(participant)
    parameters = standard_parameters(second.submit(fit_recorded, layout, SAMPLE_RATE, recorded).result())
    driven = (drive_trial(number, participant, parameters, floorplan, path) for number in range(1, trials + 1))
    scored = []
    for trial in _scored(driven, floorplan, path, second):
        scored.append(trial)
        if progress is not None:
            progress(trial)
    rows = [{"trial": trial.number, **trial.measures} for trial in scored]
    curves = second.submit(learning_curves, rows).result()
    return StudyResult(seed, floorplan, path, person, SAMPLE_RATE, parameters, tuple(scored), curves)


def _scored(
    driven: Iterable[DrivenTrial], floorplan: FloorPlan, path: PrescribedPath, second: Executor
) -> Iterator[StudyTrial]:
    """Yield each trial with its measures; it is scored while the next one is driven."""
    before: Future[StudyTrial] | None = None
    for trial in driven:
        latest = second.submit(score_trial, floorplan, path, trial)
        if before is not None:
            yield before.result()
        before = latest
    if before is not None:
        yield before.result()


def shirt_layout() -> ShirtLayout:
    """Return the layout of the simulated shirt: the paper's 52 channels."""
    return read_layout(data_folder() / "shirts" / SHIRT)
