"""Incidents: an archive was made, and the patients in it must not be erased before an owner lifts the mark."""

from collections.abc import Iterable
from datetime import datetime

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.refusals import Conflict
from app.store.access.visible_patients import WITH_DELETED, own_clinic_id
from app.store.keeping.keeping_tables import Incident, IncidentPatient
from app.store.log import write_log
from app.store.own_rows import own_row
from app.texts import Text


def mark_incident(db: Session, since: datetime, digest: str, patients: Iterable[int], person: str | None) -> Incident:
    """Store that an archive was made, and that these patients must not be erased."""
    incident = Incident(clinic_id=own_clinic_id(db), made=utc_now(), since=since, hash=digest, lifted=None, reason=None)
    db.add(incident)
    db.flush()
    db.add_all(IncidentPatient(incident_id=incident.id, patient_id=patient) for patient in patients)
    write_log(db, person, "incident archived", incident=incident.id, hash=digest, since=since.isoformat())
    return incident


def all_incidents(db: Session) -> list[tuple[Incident, list[int]]]:
    """Return the clinic's incidents, the newest first, each with the ids of its patients."""
    query = select(IncidentPatient).order_by(IncidentPatient.patient_id)
    marked = list(db.scalars(query, execution_options=WITH_DELETED))
    incidents = db.scalars(select(Incident).order_by(Incident.id.desc()))
    return [
        (incident, [mark.patient_id for mark in marked if mark.incident_id == incident.id]) for incident in incidents
    ]


def incident_of(db: Session, patient_id: int) -> Incident | None:
    """Return an incident whose mark is not lifted and that this patient is part of, None when there is none."""
    query = select(Incident).join(IncidentPatient, IncidentPatient.incident_id == Incident.id)
    query = query.where(IncidentPatient.patient_id == patient_id, Incident.lifted.is_(None))
    return db.scalar(query.limit(1), execution_options=WITH_DELETED)


def lift_incident(db: Session, incident_id: int, reason: str, person: str) -> None:
    """Permit that the records of an incident are erased."""
    incident = own_row(db, Incident, incident_id, Text("store-no-incident", incident=incident_id))
    if incident.lifted is not None:
        raise Conflict(Text("store-incident-lifted"))
    incident.lifted, incident.reason = utc_now(), reason
    write_log(db, person, "incident mark lifted", incident=incident_id)
