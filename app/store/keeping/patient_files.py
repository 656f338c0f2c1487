"""Assign an uploaded file to the patient whose session was open."""

from sqlalchemy import update
from sqlalchemy.orm import Session

from app.store.access.visible_patients import WITH_DELETED
from app.store.keeping.keeping_tables import PatientFile
from app.store.patients import open_session


def add_patient_file(db: Session, name: str) -> None:
    """Assign a file to the patient of the open session; to nobody when no session is open."""
    db.execute(
        update(PatientFile).where(PatientFile.name == name).values(current=False), execution_options=WITH_DELETED
    )
    session = open_session(db)
    if session is not None:
        db.add(PatientFile(patient_id=session.patient_id, name=name, current=True))
