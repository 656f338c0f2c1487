"""A clinic with one patient and a recorded trial, to be exported."""

from pathlib import Path

from recorded_trial import plan_of, record_trial, store_trial

from app.clock import utc_now
from app.features.consents.service import give_consent
from app.session.recordings import MEASURES_VERSION
from app.settings import Settings
from app.source import Source
from app.store.database import Database
from app.store.parameters import current_parameters, save_parameters, save_profile
from app.store.patients import add_patient
from app.store.runs import close_run
from app.store.tables import Clinic, PatientSession
from building import make_parameters

CODE = "=P-1"
RUN = "0123456789abcdef0123456789abcdef"
SIMULATED = Source(shirt="simulator", body="person", chair="virtual", simulated=True)
MEASURES = {
    "reached": True,
    "dist": 6.25,
    "e_diff": 0.1 + 0.2,
    "time": 12.5,
    "stops": 1,
    "sparc": -1.625,
    "measures_version": MEASURES_VERSION,  # else a program that starts measures the trial again from its recording
}


def make_clinic(state: Path, *, consent: bool = True) -> Settings:
    """Make a clinic in `state` with a patient of the code '=P-1' and one trial."""
    settings = Settings(state=state)
    database = Database(settings.database)
    plan = plan_of()
    with database.transaction() as db:
        clinic = Clinic(name="Riverside", created=utc_now(), unused=[])
        db.add(clinic)
        db.flush()
        patient = add_patient(db, CODE, "Heron", "=1+1")
        if consent:
            give_consent(db, patient.id, "sharing", utc_now().astimezone().date(), "Ana")
        session = PatientSession(
            clinic_id=clinic.id,
            patient_id=patient.id,
            number=1,
            started=utc_now(),
            ended=utc_now(),
            accepted=True,
            goal="To cross the yard.",
            version="0.2.0",
        )
        db.add(session)
        db.flush()
        parameters = make_parameters()
        save_parameters(db, save_profile(db, patient.id, session.id, parameters.profile), parameters)
        row, _ = current_parameters(db, patient.id)
        store_trial(db, RUN, (session, row), plan, SIMULATED, MEASURES)
        close_run(db, RUN, 400, 0)
    database.close()
    record_trial(settings.runs / RUN, parameters, seconds=4.0, plan=plan, without_frame={7, 8}, missing={50})
    return settings
