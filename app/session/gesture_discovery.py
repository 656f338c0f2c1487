"""Finds a calibration's gestures in its recordings: of the one under way, or of the newest that was accepted."""

from collections.abc import Callable
from functools import lru_cache
from pathlib import Path

from app.calibration.cued_runs import CuedRun, run_of_cues
from app.calibration.gestures.discovery import Discovery, discover, discovery_from_profile
from app.calibration.profile import CalibrationProfile
from app.calibration.script import Step, calibration_script
from app.recording.reader import read_run
from app.refusals import Conflict
from app.store.calibrations import recordings_behind, recordings_of
from app.store.database import Database
from app.store.parameters import newest_profile
from app.store.tables import PatientSession

KEPT = 8  # results: the controls ask again with every change
NOTHING = "Nothing is calibrated yet: go to Calibrate and accept a result first."
GONE = (
    "The recordings of this calibration are not here, so that only the way there is ranked, by the profile's own "
    "numbers: calibrate again to see all."
)


def of_result(database: Database, folder_of: Callable[[str], Path], session_id: int) -> Discovery:
    """Return the gestures of the session's fitted calibration; of the patient's newest map when it has none to accept.

    Raises
    ------
    Conflict
        When nothing is calibrated.
    """
    with database.transaction() as db:
        session = db.get_one(PatientSession, session_id)
        document, patient_id = session.result, session.patient_id
        waits = document is not None and not session.accepted
        folders = recordings_of(db, session_id)
    if document is None or not waits:
        return of_newest(database, folder_of, patient_id)
    return _found(CalibrationProfile.model_validate(document), folders, folder_of)


def of_newest(database: Database, folder_of: Callable[[str], Path], patient_id: int) -> Discovery:
    """Return the gestures of the patient's newest map, judged by the recordings of the calibration behind it.

    Raises
    ------
    Conflict
        When nothing is calibrated.
    """
    with database.transaction() as db:
        row = newest_profile(db, patient_id)
        if row is None:
            raise Conflict(NOTHING)
        document, folders = row.document, recordings_behind(db, row)
    return _found(CalibrationProfile.model_validate(document), folders, folder_of)


def _found(profile: CalibrationProfile, folders: dict[str, str], folder_of: Callable[[str], Path]) -> Discovery:
    recorded = tuple((step, str(folder_of(folder))) for step, folder in sorted(folders.items()))
    if recorded:
        try:
            return _discovered(profile.model_dump_json(), recorded)
        except (ValueError, OSError):  # a disk that was tidied up; the profile's own numbers are still there
            pass
    return discovery_from_profile(profile, GONE)


@lru_cache(maxsize=KEPT)
def _discovered(profile_json: str, recorded: tuple[tuple[str, str], ...]) -> Discovery:
    """Return the same for the same map and recordings, which never change once they are closed."""
    profile = CalibrationProfile.model_validate_json(profile_json)
    steps = {step.id: step for step in calibration_script(profile.layout)}
    return discover(profile, [read_cued_run(steps[step], Path(folder)) for step, folder in recorded if step in steps])


def read_cued_run(step: Step, folder: Path) -> CuedRun:
    """Return the recording of one step; ValueError or OSError when it cannot be read."""
    frames = read_run(folder).frames()
    return run_of_cues(frames["values"], frames["cue"], step.cues)
