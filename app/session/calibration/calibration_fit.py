"""Fits a session's calibration from its recorded steps and from other people, and adds it to what is known of them."""

from pathlib import Path

from app.calibration.script import Step
from app.computing_process import ComputingProcess
from app.layout import ShirtLayout
from app.refusals import Conflict
from app.session.calibration.calibration_progress import Progress
from app.session.calibration.clinic_prior import ClinicPrior, Garment
from app.session.equipment.shirt import Equipment
from app.session.recordings import entry_of_recordings, fit_recordings
from app.session.runs import SessionRuns
from app.store.calibrations import is_calibration_simulated, recordings_of
from app.store.database import Database
from app.store.tables import PatientSession


class CalibrationFit:
    """Reads the recordings of a calibration in the computing process; its methods are called in a thread."""

    def __init__(
        self,
        database: Database,
        runs: SessionRuns,
        equipment: Equipment,
        computing: ComputingProcess,
        prior: ClinicPrior,
    ) -> None:
        self._database = database
        self._runs = runs
        self._equipment = equipment
        self._computing = computing
        self._prior = prior

    def fit(self, session_id: int, progress: Progress) -> None:
        """Fit the map from the done steps, and store it as the session's result."""
        layout, recorded = self._recorded(session_id, progress)
        prior = self._prior.of_others(session_id, garment(layout, self._equipment))
        profile = self._computing.ask(fit_recordings, layout, recorded, self._equipment.unused, prior)
        with self._database.transaction() as db:
            session = db.get_one(PatientSession, session_id)
            session.result, session.accepted = profile.model_dump(mode="json"), False

    def learn(self, session_id: int, progress: Progress) -> bool:
        """Add the calibration to the clinic's prior; return whether it could be added."""
        layout, recorded = self._recorded(session_id, progress)
        shirt = garment(layout, self._equipment)
        if not self._prior.may_learn(session_id, shirt):
            return False
        try:
            entry = self._computing.ask(entry_of_recordings, layout, recorded)
        except (ValueError, OSError):  # nothing was prompted, or a recording is gone: there is nothing to add
            return False
        self._prior.add(session_id, shirt, entry)
        return True

    def _recorded(self, session_id: int, progress: Progress) -> tuple[ShirtLayout, list[tuple[Step, Path]]]:
        """Return the layout and the done steps with their recordings; Conflict when they cannot be used together."""
        if progress.layout is None:
            raise Conflict("There is no shirt: choose one on the Shirt page, then begin the calibration anew.")
        with self._database.transaction() as db:
            folders = recordings_of(db, session_id)
            is_calibration_simulated(db, session_id)  # refuse a mixture of worn and simulated recordings
        done = [step for step in progress.steps if progress.status[step.id][0] == "done"]
        return progress.layout, [(step, self._runs.folder_of(folders[step.id])) for step in done]


def garment(layout: ShirtLayout, equipment: Equipment) -> Garment:
    """Return the shirt in use, with the layout that its calibration began with."""
    return Garment(layout, bool(equipment.simulated), equipment.seed)
