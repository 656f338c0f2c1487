"""Find the gestures of a calibration in its recordings: of the one under way, or of the newest accepted one."""

from collections.abc import Callable
from pathlib import Path

from app.calibration.cued_runs import CuedRun, run_of_cues
from app.calibration.gestures.discovery import Discovery, discover, discovery_from_profile
from app.calibration.profile import CalibrationProfile
from app.calibration.script import Step, calibration_script
from app.computing_process import ComputingProcess
from app.derived_results import DerivedResults
from app.recording.reader import read_run
from app.refusals import Conflict
from app.store.calibrations import recordings_behind, recordings_of
from app.store.database import Database
from app.store.parameters import newest_profile
from app.store.tables import PatientSession
from app.texts import Text

Recorded = tuple[tuple[str, str], ...]
"""Steps of a calibration, each with the folder of its recording."""

KEPT = 8  # results: the Controls page asks again with every change
GONE = Text("calibration-recordings-gone")


class GestureDiscoveries:
    """Finds the gestures of maps in the recordings of their calibrations, each once: closed recordings never change."""

    def __init__(self, database: Database, folder_of: Callable[[str], Path], computing: ComputingProcess) -> None:
        self._database, self._folder_of, self._computing = database, folder_of, computing
        self._found: DerivedResults[tuple[str, Recorded], Discovery] = DerivedResults(KEPT)

    def of_session(self, session_id: int) -> Discovery:
        """Return the gestures of the session's fitted calibration, or of the patient's newest map when none waits.

        Raises
        ------
        Conflict
            When nothing is calibrated.
        """
        with self._database.reading() as db:
            session = db.get_one(PatientSession, session_id)
            document, patient_id = session.result, session.patient_id
            is_waiting = document is not None and not session.accepted
            folders = recordings_of(db, session_id)
        if document is None or not is_waiting:
            return self.of_patient(patient_id)
        return self._discovery(CalibrationProfile.model_validate(document), folders)

    def of_patient(self, patient_id: int) -> Discovery:
        """Return the gestures of the patient's newest map, ranked by the recordings of its calibration.

        Raises
        ------
        Conflict
            When nothing is calibrated.
        """
        with self._database.reading() as db:
            row = newest_profile(db, patient_id)
            if row is None:
                raise Conflict(Text("visit-not-calibrated"))
            document, folders = row.document, recordings_behind(db, row)
        return self._discovery(CalibrationProfile.model_validate(document), folders)

    def _discovery(self, profile: CalibrationProfile, folders: dict[str, str]) -> Discovery:
        recorded = tuple((step, str(self._folder_of(folder))) for step, folder in sorted(folders.items()))
        if recorded:
            try:
                key = profile.model_dump_json(), recorded
                return self._found.of(key, lambda: self._computing.ask(recorded_discovery, profile, recorded))
            except (ValueError, OSError):  # the recordings were deleted; the profile's own numbers are still there
                pass
        return discovery_from_profile(profile, GONE)


def recorded_discovery(profile: CalibrationProfile, recorded: Recorded) -> Discovery:
    """Return the gestures of a map and the recordings of its calibration, (step, folder) each."""
    steps = {step.id: step for step in calibration_script(profile.layout)}
    return discover(profile, [read_cued_run(steps[step], Path(folder)) for step, folder in recorded if step in steps])


def read_cued_run(step: Step, folder: Path) -> CuedRun:
    """Return the recording of one step; ValueError or OSError when it cannot be read."""
    frames = read_run(folder).frames()
    return run_of_cues(frames["values"], frames["cue"], step.cues)
