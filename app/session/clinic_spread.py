"""The clinic's median spread in each task, that a verdict is drawn towards (docs/decisions/0023)."""

from typing import NamedTuple

from app.computing_process import ComputingProcess
from app.scoring.verdict.measure_verdict import PeopleVariances, clinic_spreads, people_variances
from app.scoring.verdict.spread import Spread, SpreadsOf
from app.source import SourceGroup
from app.store.access.visible_patients import OWN_CLINIC, every_patient
from app.store.database import Database
from app.store.learning_trials import count_of_everybody, prior_consents, trials_of_everybody

MORE = 0.05  # of the trials, driven or gone since, after which the variances are estimated again


class Task(NamedTuple):
    """One path of a floor plan, driven with one kind of source."""

    floorplan: str
    path: str
    group: SourceGroup


class ClinicSpread:
    """Estimates everybody's variances in a task, and again when the clinic has driven a twentieth more of it.

    When a patient gives or withdraws the consent to it, it estimates them at once.

    A clinic of 60,000 trials needs about a second for that, so the variances stay in memory.
    """

    def __init__(self, database: Database, computing: ComputingProcess) -> None:
        self._database, self._computing = database, computing
        # No DerivedResults: an estimate holds on while the trials are nearly those that it was made of.
        self._known: dict[tuple[int | None, Task], tuple[int, frozenset[int], PeopleVariances]] = {}

    def of_others(self, task: Task, patient_id: int) -> dict[str, Spread]:
        """Return the median spread of all patients but this one, for each measure that enough of them have."""
        return clinic_spreads(self._variances(task), patient_id)

    def for_patient(self, patient_id: int) -> SpreadsOf:
        """Return a function that returns the median spread of all patients but this one in a task."""
        return lambda floorplan, path, group: self.of_others(Task(floorplan, path, group), patient_id)

    def _variances(self, task: Task) -> PeopleVariances:
        key = OWN_CLINIC.get(), task
        with every_patient(), self._database.reading() as db:
            count = count_of_everybody(db, task.floorplan, task.path)
            consents = prior_consents(db, task.group)
            then, then_consents, before = self._known.get(key, (0, consents, None))
            if before is not None and consents == then_consents and abs(count - then) <= MORE * then:
                return before
            people = trials_of_everybody(db, *task)
        variances = self._computing.ask(people_variances, people)
        self._known[key] = count, consents, variances
        return variances
