"""The demonstration clinic: a patient in an open session, calibrated and ready to drive, and one never calibrated."""

from pathlib import Path

from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import standard_parameters
from app.clock import utc_now
from app.settings import data_folder
from app.store.database import Database
from app.store.parameters import save_parameters, save_profile
from app.store.patients import add_patient, start_session
from app.store.people import add_clinic

PATIENT = ("DEMO-1", "Kingfisher", "A demonstration patient: nobody real. Calibrated in the simulated shirt.")
NEWCOMER = ("DEMO-2", "Heron", "A demonstration patient: nobody real. Never calibrated: drives by what others taught.")


def profile_file() -> Path:
    """Return the file of the simulated person's calibration; `make shipped FILE=demo-profile` writes it."""
    return data_folder() / "demo" / "profile.json"


def furnish(database: Database) -> None:
    """Make the clinic; its first patient was calibrated by the application's own calibration."""
    shipped = CalibrationProfile.model_validate_json(profile_file().read_bytes())
    profile = shipped.model_copy(update={"created": utc_now().isoformat(timespec="seconds")})
    with database.transaction() as db:
        add_clinic(db, "Demonstration")
        patient = add_patient(db, *PATIENT)
        add_patient(db, *NEWCOMER)
        session = start_session(db, patient.id)
        row = save_profile(db, patient.id, session.id, profile, simulated=True)
        save_parameters(db, row, standard_parameters(profile))
