"""The tables of a clinic: patients, sessions, screens, calibrations, parameters, trials, chairs, drives, the log."""

import json
from datetime import UTC, datetime
from typing import Final, Literal

from sqlalchemy import (
    JSON,
    Connection,
    DateTime,
    Float,
    ForeignKey,
    Index,
    MetaData,
    String,
    UniqueConstraint,
    event,
    text,
)
from sqlalchemy.engine import Dialect
from sqlalchemy.orm import DeclarativeBase, Mapped, mapped_column, relationship
from sqlalchemy.types import TypeDecorator

from app.json_values import JsonDocument
from app.source import Source
from app.texts import Text, from_document, to_document
from app.world.place_texts import place_text

COUNTED = "kept = 1 AND status = 'done' AND measures != 'null'"  # a trial that is compared with others


TrialEnding = Literal["goal", "time-out", "by hand", "fault"]
DriveEnding = Literal["by hand", "fault"]
InterfaceTestEnding = Literal["complete", "by hand", "stopped", "fault"]


class Moment(TypeDecorator[datetime]):
    """A moment in UTC; SQLite stores no time zone, so it is added again on reading."""

    impl = DateTime(timezone=True)
    cache_ok = True

    def process_bind_param(self, value: datetime | None, dialect: Dialect) -> datetime | None:  # noqa: ARG002
        """Store UTC."""
        return None if value is None else value.astimezone(UTC)

    def process_result_value(self, value: datetime | None, dialect: Dialect) -> datetime | None:  # noqa: ARG002
        """Read UTC."""
        return None if value is None else value.replace(tzinfo=UTC)


class TextColumn(TypeDecorator[Text | str]):
    """A text as MARK and its document in JSON, so that it is read in any language; a string is stored as it is."""

    impl = String
    cache_ok = True

    MARK: Final = "\x1e"  # no string begins with it: what people write has no control characters (app/visible_text.py)

    def process_bind_param(self, value: Text | str | None, dialect: Dialect) -> str | None:  # noqa: ARG002
        """Store the id and the values of a text."""
        return self.MARK + json.dumps(to_document(value)) if isinstance(value, Text) else value

    def process_result_value(self, value: str | None, dialect: Dialect) -> Text | str | None:  # noqa: ARG002
        """Read a text, or the string that was stored."""
        if value is None or not value.startswith(self.MARK):
            return value
        return from_document(json.loads(value.removeprefix(self.MARK)))


class Table(DeclarativeBase):
    """Base of all tables."""

    metadata = MetaData(
        naming_convention={
            "ix": "ix_%(table_name)s_%(column_0_N_name)s",
            "uq": "uq_%(table_name)s_%(column_0_N_name)s",
            "fk": "fk_%(table_name)s_%(column_0_name)s",
            "pk": "pk_%(table_name)s",
        }
    )
    type_annotation_map = {  # noqa: RUF012
        datetime: Moment,
        JsonDocument: JSON,
        list[int]: JSON,
        list[str]: JSON,
        list[JsonDocument]: JSON,
        list[list[float]]: JSON,
    }


class Clinic(Table):
    """One place with its people, patients and equipment."""

    __tablename__ = "clinic"
    id: Mapped[int] = mapped_column(primary_key=True)
    name: Mapped[str] = mapped_column(String(80))
    created: Mapped[datetime]
    shirt: Mapped[JsonDocument | None]  # configuration of the shirt in use
    body: Mapped[JsonDocument | None]  # configuration of the simulated body inside a simulated shirt
    unused: Mapped[list[str]]  # names of channels that are marked as unused
    head: Mapped[JsonDocument | None]  # configuration of the head tracker in use; None: none
    # The chair in use: its id (None: the virtual one), and the dynamics of the virtual one.
    chair: Mapped[JsonDocument | None]
    limits: Mapped[JsonDocument | None]  # the clinic's speed limits; None: the owner has set none


class Patient(Table):
    """A patient, who wears the shirt: a pseudonym and a code, no name."""

    __tablename__ = "patient"
    __table_args__ = (UniqueConstraint("clinic_id", "code"),)
    id: Mapped[int] = mapped_column(primary_key=True)
    clinic_id: Mapped[int] = mapped_column(ForeignKey("clinic.id"))
    code: Mapped[str] = mapped_column(String(64))
    pseudonym: Mapped[str] = mapped_column(String(80))
    note: Mapped[str] = mapped_column(String(2000))
    adaptation: Mapped[str] = mapped_column(String(8), server_default="off")  # of the map: off, suggest, auto
    created: Mapped[datetime]
    deleted: Mapped[datetime | None]  # the row stays for 30 days, so that the deletion can be undone
    deletion_reason: Mapped[str | None] = mapped_column(String(400))  # given when records must be kept for longer


class PatientSession(Table):
    """A session: one visit of a patient."""

    __tablename__ = "session"
    __table_args__ = (
        UniqueConstraint("patient_id", "number"),
        # At most one session of a clinic is open: a clinic has one machine.
        Index("uq_session_open", "clinic_id", unique=True, sqlite_where=text("ended IS NULL")),
    )
    id: Mapped[int] = mapped_column(primary_key=True)
    clinic_id: Mapped[int] = mapped_column(ForeignKey("clinic.id"))
    patient_id: Mapped[int] = mapped_column(ForeignKey("patient.id"))
    number: Mapped[int]  # 1, 2, 3 ... per patient
    started: Mapped[datetime]
    opened_by: Mapped[str | None] = mapped_column(String(80))  # a person's name; None: not recorded
    ended: Mapped[datetime | None]
    script: Mapped[JsonDocument | None]  # the calibration under way: its layout; survives a restart
    current_step: Mapped[str | None] = mapped_column(String(64))
    result: Mapped[JsonDocument | None]  # the fitted profile before it is accepted
    accepted: Mapped[bool]
    screen: Mapped[JsonDocument | None]  # settings of the patient's screens; None: the standard ones
    goal: Mapped[str] = mapped_column(String(1000), default="")  # in the patient's words
    # Of the software that it began with; "": not recorded.
    version: Mapped[str] = mapped_column(String(40), default="")


class PatientScreen(Table):
    """A screen that the patient looks at, paired for one session; its token itself is never stored."""

    __tablename__ = "patient_screen"
    id: Mapped[int] = mapped_column(primary_key=True)
    clinic_id: Mapped[int] = mapped_column(ForeignKey("clinic.id"))
    session_id: Mapped[int] = mapped_column(ForeignKey("session.id"), index=True)
    token_hash: Mapped[str] = mapped_column(String(64), unique=True)
    number: Mapped[int]  # 1, 2, 3 ... per session
    paired: Mapped[datetime]
    expires: Mapped[datetime]
    unpaired: Mapped[datetime | None]


class CalibrationStep(Table):
    """The status of one step of the calibration under way."""

    __tablename__ = "calibration_step"
    session_id: Mapped[int] = mapped_column(ForeignKey("session.id"), primary_key=True)
    step: Mapped[str] = mapped_column(String(64), primary_key=True)
    status: Mapped[str] = mapped_column(String(16))  # waiting, running, done, failed, skipped
    words: Mapped[Text | str] = mapped_column(TextColumn(400))
    run_id: Mapped[str | None] = mapped_column(ForeignKey("run.id"), index=True)


class Run(Table):
    """One uninterrupted recording, and the folder that holds it."""

    __tablename__ = "run"
    id: Mapped[str] = mapped_column(String(36), primary_key=True)
    session_id: Mapped[int] = mapped_column(ForeignKey("session.id"), index=True)
    kind: Mapped[str] = mapped_column(String(16))  # rest, free, prompt, drive
    folder: Mapped[str]  # relative to the folder of all runs
    started: Mapped[datetime]
    ended: Mapped[datetime | None]
    rows: Mapped[int | None]
    dropped: Mapped[int | None]
    # The source (app/source.py), as the control process named it when the run began; never changed afterwards.
    shirt: Mapped[str] = mapped_column(String(32), server_default="unknown")
    body: Mapped[str | None] = mapped_column(String(32))
    chair: Mapped[str] = mapped_column(String(32), server_default="unknown")
    simulated: Mapped[bool | None]  # None: unknown

    @property
    def source(self) -> Source:
        """Return where the signals of this run came from."""
        return Source(shirt=self.shirt, body=self.body, chair=self.chair, simulated=self.simulated)


class Profile(Table):
    """An accepted map; never changed, only succeeded by a newer version."""

    __tablename__ = "profile"
    __table_args__ = (UniqueConstraint("patient_id", "version"),)
    id: Mapped[int] = mapped_column(primary_key=True)
    patient_id: Mapped[int] = mapped_column(ForeignKey("patient.id"))
    session_id: Mapped[int] = mapped_column(ForeignKey("session.id"), index=True)
    version: Mapped[int]
    # calibration, adaptation, donning or back
    origin: Mapped[str] = mapped_column(String(16), server_default="calibration")
    parent: Mapped[int | None]  # version of the same patient that it was made from; None: from a calibration
    difference: Mapped[JsonDocument | None]  # the changes from the parent
    document: Mapped[JsonDocument]
    created: Mapped[datetime]
    simulated: Mapped[bool | None]  # whether nobody wore the shirt in which it was calibrated; None: unknown


class ParameterSet(Table):
    """One parameter set on one profile; undo and redo move `current` from one to another."""

    __tablename__ = "parameters"
    id: Mapped[int] = mapped_column(primary_key=True)
    profile_id: Mapped[int] = mapped_column(ForeignKey("profile.id"), index=True)
    title: Mapped[str] = mapped_column(String(80))
    settings: Mapped[JsonDocument]  # DriveParameters without the profile
    hash: Mapped[str] = mapped_column(String(64))
    created: Mapped[datetime]
    current: Mapped[bool]
    abandoned: Mapped[bool]  # it was undone, and then another set was made


class Trial(Table):
    """One attempt along a path."""

    __tablename__ = "trial"
    __table_args__ = (
        UniqueConstraint("patient_id", "floorplan", "path", "number"),
        Index(None, "floorplan", "path", "status"),
        Index(None, "patient_id", "status", "kept"),
        Index(None, "patient_id", "floorplan", "path", "status"),
        Index(None, "clinic_id", "end", "started"),
        Index("ix_trial_counted", "clinic_id", "patient_id", "floorplan", "path", "run_id", sqlite_where=text(COUNTED)),
    )
    id: Mapped[int] = mapped_column(primary_key=True)
    clinic_id: Mapped[int] = mapped_column(ForeignKey("clinic.id"))
    patient_id: Mapped[int] = mapped_column(ForeignKey("patient.id"))
    session_id: Mapped[int] = mapped_column(ForeignKey("session.id"), index=True)
    parameters_id: Mapped[int] = mapped_column(ForeignKey("parameters.id"), index=True)
    run_id: Mapped[str] = mapped_column(ForeignKey("run.id"), index=True)
    run: Mapped[Run] = relationship(lazy="joined", innerjoin=True)
    number: Mapped[int]
    floorplan: Mapped[str] = mapped_column(String(64))
    floorplan_title: Mapped[str] = mapped_column(String(80))
    path: Mapped[str] = mapped_column(String(64))
    path_points: Mapped[list[list[float]]]  # copied, because the floor plan may change later
    started: Mapped[datetime]
    status: Mapped[str] = mapped_column(String(16))  # running, done
    end: Mapped[str | None] = mapped_column(String(16))  # a TrialEnding
    kept: Mapped[bool]
    discard_reason: Mapped[Text | str | None] = mapped_column(TextColumn(200))  # a string: by a person
    measures: Mapped[JsonDocument | None]
    # A long document: only a query that names it reads it.
    quality: Mapped[JsonDocument | None] = mapped_column(deferred=True, deferred_raiseload=True)

    @property
    def source(self) -> Source:
        """Return where the signals of its run came from."""
        return self.run.source

    @property
    def place_title(self) -> Text | str:
        """Return the title of its floor plan for people; `floorplan_title` is that of the document."""
        return place_text(self.floorplan, self.floorplan_title)


class PairedChair(Table):
    """A real chair that shares a key with this machine; the key itself lies in a file, never here."""

    __tablename__ = "chair"
    __table_args__ = (UniqueConstraint("clinic_id", "key_id"),)
    id: Mapped[int] = mapped_column(primary_key=True)
    clinic_id: Mapped[int] = mapped_column(ForeignKey("clinic.id"))
    name: Mapped[str] = mapped_column(String(80))
    host: Mapped[str] = mapped_column(String(253))
    port: Mapped[int]
    key_id: Mapped[int]
    speeds: Mapped[JsonDocument]  # the speed limits of this chair
    paired: Mapped[datetime]
    removed: Mapped[datetime | None]  # the row stays, because drives refer to it


class Drive(Table):
    """One drive of a real chair, from arming to its end."""

    __tablename__ = "drive"
    id: Mapped[int] = mapped_column(primary_key=True)
    clinic_id: Mapped[int] = mapped_column(ForeignKey("clinic.id"))
    patient_id: Mapped[int] = mapped_column(ForeignKey("patient.id"), index=True)
    session_id: Mapped[int] = mapped_column(ForeignKey("session.id"), index=True)
    run_id: Mapped[str] = mapped_column(ForeignKey("run.id"), index=True)
    run: Mapped[Run] = relationship(lazy="joined", innerjoin=True)
    chair_id: Mapped[int] = mapped_column(ForeignKey("chair.id"), index=True)
    parameters_id: Mapped[int] = mapped_column(ForeignKey("parameters.id"), index=True)
    hash: Mapped[str] = mapped_column(String(64))  # of the parameter set as it was armed
    started: Mapped[datetime]
    ended: Mapped[datetime | None]
    end: Mapped[str | None] = mapped_column(String(16))  # a DriveEnding
    distance: Mapped[float | None] = mapped_column(Float)  # m

    @property
    def source(self) -> Source:
        """Return where the signals of its run came from."""
        return self.run.source


class InterfaceTest(Table):
    """One interface test: targets on a cross, reached with a cursor that u1 and u2 move, while no chair moves."""

    __tablename__ = "interface_test"
    __table_args__ = (UniqueConstraint("patient_id", "number"),)
    id: Mapped[int] = mapped_column(primary_key=True)
    clinic_id: Mapped[int] = mapped_column(ForeignKey("clinic.id"))
    patient_id: Mapped[int] = mapped_column(ForeignKey("patient.id"))
    session_id: Mapped[int] = mapped_column(ForeignKey("session.id"), index=True)
    parameters_id: Mapped[int] = mapped_column(ForeignKey("parameters.id"), index=True)
    run_id: Mapped[str] = mapped_column(ForeignKey("run.id"), index=True)
    run: Mapped[Run] = relationship(lazy="joined", innerjoin=True)
    number: Mapped[int]  # 1, 2, 3 ... per patient
    started: Mapped[datetime]
    status: Mapped[str] = mapped_column(String(16))  # running, done
    end: Mapped[str | None] = mapped_column(String(16))  # an InterfaceTestEnding
    plan: Mapped[JsonDocument]  # what was asked (app.world.cursor_task.CursorPlan)
    measures: Mapped[JsonDocument | None]  # app.scoring.interface_test.InterfaceMeasures
    workload: Mapped[JsonDocument | None]  # answers of the NASA task load index, 0 to 100 each; None: not asked

    @property
    def source(self) -> Source:
        """Return where the signals of its run came from."""
        return self.run.source


class LogEntry(Table):
    """A row of the log: who did what, when. Its hash covers the row before, so that a change can be detected."""

    __tablename__ = "log"
    id: Mapped[int] = mapped_column(primary_key=True)
    at: Mapped[datetime]
    person: Mapped[str | None] = mapped_column(String(80))
    what: Mapped[str] = mapped_column(String(40))
    details: Mapped[JsonDocument]
    previous_hash: Mapped[str] = mapped_column(String(64))
    hash: Mapped[str] = mapped_column(String(64))


@event.listens_for(LogEntry.__table__, "after_create")
def _only_append(_table: object, connection: Connection, **_options: object) -> None:
    for change in ("UPDATE", "DELETE"):
        connection.exec_driver_sql(
            f"CREATE TRIGGER log_no_{change.lower()} BEFORE {change} ON log "
            "BEGIN SELECT RAISE(ABORT, 'the log is only ever appended to'); END"
        )
