"""In which tasks each patient has become worse than noise explains: worked out in the background, and kept.

A task of twenty sessions needs more than a tenth of a second, and a clinic of 200 patients more than a minute. So a
page is answered at once with what is known; what is not is worked out one task after the other, and again when the
trials that count in it have changed. Each is judged with the clinic's spread of that moment.
"""

import logging
import threading
from collections.abc import Sequence
from typing import NamedTuple

from app.computing_process import ComputingProcess
from app.derived_results import DerivedResults
from app.refusals import Refusal
from app.scoring.verdict.deterioration import deteriorations
from app.session.clinic_spread import ClinicSpread, Task
from app.source import SourceGroup
from app.store.access.visible_patients import every_patient, of_clinic
from app.store.database import Database
from app.store.learning_trials import counted_trials
from app.store.tables import Patient
from app.texts import Text

LOG = logging.getLogger(__name__)
KEPT = 20_000  # tasks: more than a clinic of 1,000 patients has; with fewer, a page would never be complete


class CountedTask(NamedTuple):
    """A task (floor plan, path, source) of a patient, with the trials that count in it."""

    patient_id: int
    floorplan: str
    path: str
    group: SourceGroup
    trials: str  # their ids, joined by commas


class Deterioration(NamedTuple):
    """A task in which a patient has become worse."""

    measures: int  # how many of them
    session_id: int  # the newest session with the task
    sentence: Text


class Deteriorations:
    """Keeps what was worked out for each task of each patient, and works out what is missing. Thread-safe."""

    def __init__(self, database: Database, computing: ComputingProcess, spread: ClinicSpread) -> None:
        self._database, self._computing, self._spread = database, computing, spread
        self._known: DerivedResults[CountedTask, Deterioration | None] = DerivedResults(KEPT)
        self._missing: dict[CountedTask, None] = {}  # in the order in which they were asked for
        self._lock = threading.Lock()
        self._is_working = False

    def known(self, tasks: Sequence[CountedTask]) -> dict[CountedTask, Deterioration | None]:
        """Return what is known of these tasks, and begin to work out the others; None: no worse than noise explains."""
        with self._lock:
            known_tasks = self._known.find(tasks)
            self._missing.update({task: None for task in tasks if task not in known_tasks})
            begin = bool(self._missing) and not self._is_working
            self._is_working = self._is_working or begin
        if begin:
            threading.Thread(target=self._work, name="deteriorations", daemon=True).start()
        return known_tasks

    def _work(self) -> None:
        try:
            while (task := self._next()) is not None:
                self._keep(task, self._computed(task))
        except (Refusal, OSError, ValueError, RuntimeError) as error:
            LOG.warning("What has become worse is not known for every patient: %s", error)
            with self._lock:
                self._is_working = False
                self._missing.clear()  # whoever asks next begins again

    def _next(self) -> CountedTask | None:
        with self._lock:
            task = next(iter(self._missing), None)
            self._is_working = task is not None
            return task

    def _keep(self, task: CountedTask, deterioration: Deterioration | None) -> None:
        with self._lock:
            self._known.forget(lambda one: one[:4] == task[:4])  # with the trials that counted before
            self._known.store({task: deterioration})
            self._missing.pop(task, None)

    def _computed(self, task: CountedTask) -> Deterioration | None:
        with every_patient(), self._database.reading() as db:
            patient = db.get(Patient, task.patient_id)
            if patient is None:  # deleted meanwhile
                return None
            every = counted_trials(db, task.patient_id, task.floorplan, task.path)
            trials = [trial for trial in every if trial.group == task.group]
            rows = [trial.row() for trial in trials]
            newest = trials[-1].trial.session_id if trials else 0
        with of_clinic(patient.clinic_id):
            spread = self._spread.of_others(Task(task.floorplan, task.path, task.group), task.patient_id)
        worse = self._computing.ask_last(deteriorations, rows, spread)
        return Deterioration(len(worse), newest, next(iter(worse.values()))) if worse else None
