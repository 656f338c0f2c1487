"""The demonstration clinic: one patient in an open session, calibrated in the simulated shirt and ready to drive."""

from app.calibration.vocabulary import standard_parameters
from app.hardware.body.person import Person
from app.hardware.body.person_parameters import PRACTISED
from app.hardware.shirt.standard import standard_layout
from app.store.database import Database
from app.store.parameters import save_parameters, save_profile
from app.store.patients import add_patient, start_session
from app.store.people import add_clinic
from app.study.participant import Participant
from app.study.simulated_calibration import calibrate

PATIENT = ("DEMO-1", "Kingfisher", "A demonstration patient: nobody real. Calibrated in the simulated shirt.")
SEED = 1  # of the fabric and the person: those of the simulated shirt and body that a control process starts with
SAMPLE_RATE = 100.0  # Hz


def furnish(database: Database) -> None:
    """Make the clinic; its patient is calibrated by the application's own calibration, faster than real time."""
    profile = calibrate(Participant(Person(PRACTISED, SEED), standard_layout(), SAMPLE_RATE, SEED))
    with database.transaction() as db:
        clinic = add_clinic(db, "Demonstration")
        patient = add_patient(db, clinic.id, *PATIENT)
        session = start_session(db, clinic.id, patient.id)
        row = save_profile(db, patient.id, session.id, profile, simulated=True)
        save_parameters(db, row, standard_parameters(profile))
