"""Fits a calibration from its recorded steps, from other people, or from this person's earlier calibration."""

from pathlib import Path

from app.calibration.adaptation.donning_fit import joints_followed
from app.calibration.prior.documents import fitting_part
from app.calibration.profile import CalibrationProfile
from app.calibration.script import Step
from app.computing_process import ComputingProcess
from app.layout import ShirtLayout
from app.refusals import Conflict
from app.session.calibration.calibration_progress import EarlierCalibration, Progress
from app.session.calibration.garment import Garment, OthersPrior
from app.session.calibration.ring_override import rings_as_worn
from app.session.calibration.step_check import advice_of
from app.session.equipment.shirt import Equipment
from app.session.recordings import entry_of_recordings, fit_recordings, fit_recordings_to_donning, judge_step
from app.session.runs import SessionRuns
from app.store.calibrations import is_calibration_simulated, recordings_of, set_step
from app.store.database import Database
from app.store.log import write_log
from app.store.map_versions import calibration_behind, save_adapted, source_of_map
from app.store.parameters import as_document, current_parameters, newest_profile
from app.store.tables import PatientSession
from app.texts import Text, text_of


class CalibrationFit:
    """Reads the recordings of a calibration in the computing process; its methods are called in a thread."""

    def __init__(
        self,
        database: Database,
        runs: SessionRuns,
        equipment: Equipment,
        computing: ComputingProcess,
        prior: OthersPrior,
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
        with self._database.reading() as db:
            as_worn = rings_as_worn(db, db.get_one(PatientSession, session_id))
        profile = self._computing.ask(fit_recordings, layout, recorded, self._equipment.unused, prior, as_worn)
        with self._database.transaction() as db:
            session = db.get_one(PatientSession, session_id)
            session.result, session.accepted = profile.model_dump(mode="json"), False
            for step, _ in recorded:
                if step.kind == "prompt":
                    set_step(db, session_id, step.id, "done", advice_of(profile, step) or "")

    def judge(self, session_id: int, progress: Progress, step: Step) -> Text | str | None:
        """Store why a done step has to be repeated, in the words of the result, and return it; None if it need not."""
        layout, recorded = self._recorded(session_id, progress)
        advice = self._computing.ask(judge_step, layout, recorded, self._equipment.unused, step)
        with self._database.transaction() as db:
            set_step(db, session_id, step.id, "done", advice or "")
        return advice

    def earlier(self, session_id: int, layout: ShirtLayout) -> EarlierCalibration | None:
        """Return the calibration that the patient drives with, None without one in this kind of shirt."""
        with self._database.reading() as db:
            row = newest_profile(db, db.get_one(PatientSession, session_id).patient_id)
            if row is None or source_of_map(db, row) != self._equipment.group:
                return None
            before = CalibrationProfile.model_validate(row.document).layout
            if before.without_rings != layout.without_rings:
                return None
            return EarlierCalibration(row.version, row.created)

    def fit_earlier(self, session_id: int, progress: Progress, person: str) -> None:
        """Fit the patient's earlier calibration to this session's free movement, as the next map where it differs."""
        layout, recorded = self._recorded(session_id, progress)
        prior = self._prior.of_others(session_id, garment(layout, self._equipment))
        with self._database.reading() as db:
            patient = db.get_one(PatientSession, session_id).patient_id
            row, profile = current_parameters(db, patient)
            before, calibrated = as_document(row, profile), calibration_behind(db, profile)
        try:
            after = self._computing.ask(fit_recordings_to_donning, before, calibrated, recorded, prior)
        except ValueError as error:
            raise Conflict(text_of(error)) from error
        followed = joints_followed(before.profile, after.profile)
        if not followed:
            return
        difference = {"joints": {joint: {"range_moved": True} for joint in followed}}
        with self._database.transaction() as db:
            if as_document(*current_parameters(db, patient)).hash != before.hash:
                raise Conflict(Text("visit-controls-changed"))
            saved = save_adapted(db, patient, session_id, after, difference, origin="donning")
            write_log(db, person, "calibration fitted to the shirt", patient=patient, version=saved.version)

    def learn(self, session_id: int, progress: Progress) -> bool:
        """Add the prompted joints of the calibration to the clinic's prior; return whether there were any to add."""
        layout, recorded = self._recorded(session_id, progress)
        shirt = garment(layout, self._equipment)
        prompted = any(step.kind == "prompt" for step, _ in recorded)
        if not prompted or not self._prior.may_learn(session_id, shirt):
            return False
        try:
            entry = self._computing.ask(entry_of_recordings, layout, recorded)
        except (ValueError, OSError):  # no movement can be used, or a recording is gone: there is nothing to add
            return False
        fitting = entry if progress.profile is None else fitting_part(entry, progress.profile)
        if fitting is None:
            return False
        self._prior.add(session_id, shirt, fitting)
        return True

    def _recorded(self, session_id: int, progress: Progress) -> tuple[ShirtLayout, list[tuple[Step, Path]]]:
        """Return the layout and the done steps with their recordings; Conflict when they cannot be used together."""
        if progress.layout is None:
            raise Conflict(Text("visit-calibration-without-shirt"))
        with self._database.reading() as db:
            folders = recordings_of(db, session_id)
            is_calibration_simulated(db, session_id)  # refuse a mixture of groups of sources
        done = [step for step in progress.steps if progress.status[step.id][0] == "done"]
        return progress.layout, [(step, self._runs.folder_of(folders[step.id])) for step in done]


def garment(layout: ShirtLayout, equipment: Equipment) -> Garment:
    """Return the shirt in use, with the layout that its calibration began with."""
    return Garment(layout, equipment.group, equipment.seed)
