"""Drives of real chairs."""

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.store.access.visible_patients import own_clinic_id
from app.store.own_rows import own_row
from app.store.tables import Drive, Run
from app.texts import Text


def add_drive(db: Session, *, run: Run, patient_id: int, chair_id: int, parameters_id: int, digest: str) -> Drive:
    """Add a drive that begins; `digest` is the hash of what is armed."""
    drive = Drive(
        clinic_id=own_clinic_id(db),
        patient_id=patient_id,
        session_id=run.session_id,
        run=run,
        chair_id=chair_id,
        parameters_id=parameters_id,
        hash=digest,
        started=utc_now(),
        ended=None,
        end=None,
        distance=None,
    )
    db.add(drive)
    db.flush()
    return drive


def finish_drive(db: Session, drive_id: int, end: str, distance: float | None) -> Drive:
    """Store how a drive ended, and its length (m) by the chair's reports; None when it never moved or reported."""
    drive = db.get_one(Drive, drive_id)
    drive.ended, drive.end, drive.distance = utc_now(), end, distance
    return drive


def find_drive(db: Session, drive_id: int) -> Drive:
    """Return one of the clinic's drives."""
    return own_row(db, Drive, drive_id, Text("store-no-drive", drive=drive_id))


def drives_of(db: Session, patient_id: int) -> list[Drive]:
    """Return a patient's drives, the newest last."""
    query = select(Drive).where(Drive.patient_id == patient_id).order_by(Drive.id)
    return list(db.scalars(query))


def close_interrupted_drives(db: Session) -> list[Drive]:
    """End the drives that an ended web process left open."""
    interrupted = list(db.scalars(select(Drive).where(Drive.ended.is_(None))))
    for drive in interrupted:
        drive.ended, drive.end = utc_now(), "fault"
    return interrupted
