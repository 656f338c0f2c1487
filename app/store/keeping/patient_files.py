"""Whose an uploaded file is: that of the patient who was here when it was uploaded."""

from sqlalchemy import update
from sqlalchemy.orm import Session

from app.store.access.visible_patients import WITH_DELETED
from app.store.keeping.keeping_tables import PatientFile
from app.store.patients import open_session


def add_patient_file(db: Session, clinic_id: int, name: str) -> None:
    """Store that a file belongs to the patient who is here; it belongs to nobody while nobody is here."""
    db.execute(
        update(PatientFile).where(PatientFile.name == name).values(current=False), execution_options=WITH_DELETED
    )
    session = open_session(db, clinic_id)
    if session is not None:
        db.add(PatientFile(patient_id=session.patient_id, name=name, current=True))
