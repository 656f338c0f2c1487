"""The tables of keeping records: the owner's settings, erased patients, uploads, incidents, clocks."""

from datetime import datetime

from sqlalchemy import Float, ForeignKey, String
from sqlalchemy.orm import Mapped, mapped_column

from app.json_values import JsonDocument
from app.store.tables import Table


class RecordKeeping(Table):
    """What the owner of a clinic has set about how long records must be kept."""

    __tablename__ = "record_keeping"
    clinic_id: Mapped[int] = mapped_column(ForeignKey("clinic.id"), primary_key=True)
    years: Mapped[int | None]  # after the last session of a patient; None: the owner has set nothing


class ErasedPatient(Table):
    """A patient who was deleted for good: the id, and no word about the person."""

    __tablename__ = "erased_patient"
    id: Mapped[int] = mapped_column(primary_key=True)  # that the patient had
    created: Mapped[datetime]  # tells this patient from one to whom an older backup has given the same id
    erased: Mapped[datetime]
    files: Mapped[list[str]]  # still to be removed, relative to the state folder


class LastId(Table):
    """The highest id of a table of which rows were erased: the log names rows by their ids, so none is given twice."""

    __tablename__ = "last_id"
    name: Mapped[str] = mapped_column(String(64), primary_key=True)  # of the table
    id: Mapped[int]


class PatientFile(Table):
    """A file of recorded signals that was uploaded while the session of a patient was open."""

    __tablename__ = "patient_file"
    id: Mapped[int] = mapped_column(primary_key=True)
    patient_id: Mapped[int] = mapped_column(ForeignKey("patient.id"), index=True)
    name: Mapped[str] = mapped_column(String(80))
    current: Mapped[bool]  # no later upload has replaced it; otherwise it is on the shelf for 30 days


class Incident(Table):
    """An archive that was made after an incident; what it holds must not be deleted before the mark is lifted."""

    __tablename__ = "incident"
    id: Mapped[int] = mapped_column(primary_key=True)
    clinic_id: Mapped[int] = mapped_column(ForeignKey("clinic.id"))
    made: Mapped[datetime]
    since: Mapped[datetime]
    hash: Mapped[str] = mapped_column(String(64))  # SHA-256 of the archive's manifest
    lifted: Mapped[datetime | None]
    reason: Mapped[str | None] = mapped_column(String(400))  # why the mark was lifted


class IncidentPatient(Table):
    """A patient whose records are in the archive of an incident."""

    __tablename__ = "incident_patient"
    incident_id: Mapped[int] = mapped_column(ForeignKey("incident.id"), primary_key=True)
    patient_id: Mapped[int] = mapped_column(ForeignKey("patient.id"), primary_key=True, index=True)


class PassedTime(Table):
    """The last look at the clocks of the machine, from which follows how much time has really passed: one row."""

    __tablename__ = "passed_time"
    id: Mapped[int] = mapped_column(primary_key=True)
    wall: Mapped[datetime]
    count: Mapped[float] = mapped_column(Float)  # s, of the monotonic clock
    boot: Mapped[str] = mapped_column(String(80))  # the start of the machine in which it counts; empty: unknown
    jumps: Mapped[list[JsonDocument]]  # forward, of the wall clock (app.store.keeping.passed_time.Jump)
