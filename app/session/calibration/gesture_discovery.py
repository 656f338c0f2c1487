"""Find the gestures of a calibration in its recordings: of the one under way, or of the newest accepted one."""

from collections.abc import Callable
from functools import lru_cache
from pathlib import Path

from app.calibration.cued_runs import CuedRun, run_of_cues
from app.calibration.gestures.discovery import Discovery, discover, discovery_from_profile
from app.calibration.profile import CalibrationProfile
from app.calibration.script import Step, calibration_script
from app.computing_process import ComputingProcess
from app.recording.reader import read_run
from app.refusals import Conflict
from app.store.calibrations import recordings_behind, recordings_of
from app.store.database import Database
from app.store.parameters import newest_profile
from app.store.tables import PatientSession

KEPT = 8  # results: the Controls page asks again with every change
NOTHING = "Nothing is calibrated yet: calibrate first, and tap “Use this calibration”."
GONE = (
    "The recordings of this calibration are not here, so only the movements there are ranked, not those back, "
    "by the calibration's own numbers: calibrate again to see all."
)


def session_gestures(
    database: Database, folder_of: Callable[[str], Path], computing: ComputingProcess, session_id: int
) -> Discovery:
    """Return the gestures of the session's fitted calibration, or of the patient's newest map when none waits.

    Raises
    ------
    Conflict
        When nothing is calibrated.
    """
    with database.transaction() as db:
        session = db.get_one(PatientSession, session_id)
        document, patient_id = session.result, session.patient_id
        is_waiting = document is not None and not session.accepted
        folders = recordings_of(db, session_id)
    if document is None or not is_waiting:
        return patient_gestures(database, folder_of, computing, patient_id)
    return _discovery(CalibrationProfile.model_validate(document), folders, folder_of, computing)


def patient_gestures(
    database: Database, folder_of: Callable[[str], Path], computing: ComputingProcess, patient_id: int
) -> Discovery:
    """Return the gestures of the patient's newest map, ranked by the recordings of its calibration.

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
    return _discovery(CalibrationProfile.model_validate(document), folders, folder_of, computing)


def _discovery(
    profile: CalibrationProfile,
    folders: dict[str, str],
    folder_of: Callable[[str], Path],
    computing: ComputingProcess,
) -> Discovery:
    recorded = tuple((step, str(folder_of(folder))) for step, folder in sorted(folders.items()))
    if recorded:
        try:
            return _cached_discovery(computing, profile.model_dump_json(), recorded)
        except (ValueError, OSError):  # the recordings were deleted; the profile's own numbers are still there
            pass
    return discovery_from_profile(profile, GONE)


@lru_cache(maxsize=KEPT)
def _cached_discovery(
    computing: ComputingProcess, profile_json: str, recorded: tuple[tuple[str, str], ...]
) -> Discovery:
    """Return the gestures of a map and its recordings; cached, because closed recordings never change."""
    return computing.ask(recorded_discovery, CalibrationProfile.model_validate_json(profile_json), recorded)


def recorded_discovery(profile: CalibrationProfile, recorded: tuple[tuple[str, str], ...]) -> Discovery:
    """Return the gestures of a map and the recordings of its calibration, (step, folder) each."""
    steps = {step.id: step for step in calibration_script(profile.layout)}
    return discover(profile, [read_cued_run(steps[step], Path(folder)) for step, folder in recorded if step in steps])


def read_cued_run(step: Step, folder: Path) -> CuedRun:
    """Return the recording of one step; ValueError or OSError when it cannot be read."""
    frames = read_run(folder).frames()
    return run_of_cues(frames["values"], frames["cue"], step.cues)
