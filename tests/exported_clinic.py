"""A clinic with one patient and a recorded trial, to be exported."""

from contextlib import closing
from pathlib import Path

from clinic_rows import rows_in
from recorded_trial import record_trial

from app.features.exports.export_material import ExportMaterial, exported_material
from app.features.exports.forms import Form
from app.session.recordings import MEASURES_VERSION
from app.settings import Settings
from app.store.database import Database
from building import make_parameters, plan_of

CODE = "=P-1"
RUN = "0123456789abcdef0123456789abcdef"
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
    settings, plan, parameters = Settings(state=state), plan_of(), make_parameters()
    with rows_in(settings, "Riverside") as clinic:
        patient = clinic.patient(CODE, note="=1+1")
        if consent:
            clinic.consent(patient, "sharing")
        session = clinic.session(patient, goal="To cross the yard.", version="0.2.0")
        clinic.map(session, parameters)
        clinic.trial(session, MEASURES, plan=plan, run=RUN, ticks=400, end="by hand")
    record_trial(settings.runs / RUN, parameters, seconds=4.0, plan=plan, without_frame={7, 8}, missing={50})
    return settings


def material_of(clinic: Settings, form: Form, patient: int = 1, session: int | None = None) -> ExportMaterial:
    """Return what is exported of a clinic's patient."""
    with closing(Database(clinic.database)) as database:
        return exported_material(
            database, patient, session, form, "Ana", clinic.runs, lambda *_: {}, place=clinic.state
        )
