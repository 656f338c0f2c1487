"""The builder of test clinics in a database: people, patients, sessions, maps, trials and drives, each in one line."""

import uuid
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from datetime import datetime, timedelta
from typing import Any

from sqlalchemy.orm import Session

from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import DriveParameters
from app.clock import utc_now
from app.refusals import Conflict
from app.settings import Settings
from app.source import Source
from app.speed_limits import HIGHEST_SPEEDS
from app.store.access.person_tables import Person
from app.store.access.sign_ins import sign_in
from app.store.chairs import add_chair, chairs_of
from app.store.consent import Consent
from app.store.database import Database
from app.store.drives import add_drive, finish_drive
from app.store.parameters import current_parameters, save_parameters, save_profile
from app.store.patients import add_patient, sessions_of, start_session
from app.store.people import add_clinic, add_person, find_person, the_clinic
from app.store.runs import add_run, add_trial, close_run, finish_trial
from app.store.tables import Drive, PairedChair, ParameterSet, Patient, PatientSession, Profile, Trial
from app.world.floorplan import FloorPlan
from app.world.scene import find_place
from building import make_parameters, plan_of
from small_profile import small_profile

SIMULATED = Source(shirt="simulator", body="person", chair="virtual", simulated=True)
WORN = Source(shirt="udp", body=None, chair="virtual", simulated=False)
REAL = Source(shirt="udp", body=None, chair="udp", simulated=False)  # a worn shirt, and a real chair
ROOM = plan_of()


class ClinicRows:
    """Builds the rows of the database's clinic, which is added when there is none."""

    def __init__(self, db: Session, name: str = "Clinic") -> None:
        self.db = db
        self.clinic = the_clinic(db) or add_clinic(db, name)

    def person(
        self, name: str = "Ada", role: str = "owner", password: str | None = None, patients: list[int] | None = None
    ) -> Person:
        """Add a person; `password` is its hash, `patients` are those whom a reviewer is shown."""
        return add_person(self.db, self.clinic, name, role, password, patients=patients)

    def sign_in(self, name: str = "Ada", role: str = "owner", patients: list[int] | None = None) -> str:
        """Sign a person in, who is added unless the name is known; return the token."""
        return sign_in(self.db, find_person(self.db, name) or self.person(name, role, None, patients), "test")

    def patient(self, code: str = "P-1", pseudonym: str = "Heron", note: str = "") -> Patient:
        """Add a patient."""
        return add_patient(self.db, code, pseudonym, note)

    def consent(self, patient: Patient | int, *consents: Consent) -> None:
        """Give consents of a patient, as of today."""
        from app.features.consents.service import give_consent  # a feature, without which everything else is built

        patient_id = patient if isinstance(patient, int) else patient.id
        for consent in consents:
            give_consent(self.db, patient_id, consent, utc_now().date(), "Ada")

    def open_session(self, patient: Patient | None = None) -> PatientSession:
        """Open a session of a patient, who is added unless given."""
        return start_session(self.db, (patient or self.patient()).id, "Ada")

    def session(self, patient: Patient | int | None = None, **columns: Any) -> PatientSession:
        """Add a session of a patient, who is added unless given; it began now and has ended, unless `columns` say."""
        patient = self.patient() if patient is None else patient
        patient_id = patient if isinstance(patient, int) else patient.id
        last = max((one.number for one in sessions_of(self.db, patient_id)), default=0)
        now = utc_now()
        given = {"number": last + 1, "started": now, "ended": now, "accepted": True, **columns}
        session = PatientSession(clinic_id=self.clinic.id, patient_id=patient_id, **given)
        self.db.add(session)
        self.db.flush()
        return session

    def map(
        self, session: PatientSession, made: DriveParameters | CalibrationProfile | None = None, **how: Any
    ) -> Profile:
        """Store a map as the next version of the session's patient: `made`, or a small one; `how` is its origin."""
        made = small_profile() if made is None else made
        profile = made.profile if isinstance(made, DriveParameters) else made
        row = save_profile(self.db, session.patient_id, session.id, profile, **how)
        if isinstance(made, DriveParameters):
            save_parameters(self.db, row, made)
        return row

    def parameters(self, session: PatientSession) -> ParameterSet:
        """Return the current parameter set of the session's patient; without a map, a small one is stored."""
        try:
            return current_parameters(self.db, session.patient_id)[0]
        except Conflict:
            self.map(session)
            return current_parameters(self.db, session.patient_id)[0]

    def trial(
        self,
        session: PatientSession,
        measures: dict[str, Any] | None = None,
        *,
        plan: FloorPlan = ROOM,
        path: str | None = None,
        source: Source = SIMULATED,
        run: str = "",
        ticks: int | None = None,
        end: str | None = "goal",
        started: datetime | None = None,
    ) -> Trial:
        """Store a trial on a path of `plan` (the first, unless named), driven with the patient's current parameters.

        `end` None: it goes on; `ticks`: the rows of its recording, which has ended then.
        """
        run = run or uuid.uuid4().hex
        way = plan.path_named(path) if path else plan.paths[0]
        trial = add_trial(
            self.db,
            run=add_run(self.db, run, session.id, "drive", run, source),
            patient_id=session.patient_id,
            parameters_id=self.parameters(session).id,
            floorplan=plan.name,
            floorplan_title=plan.title,
            path=way.name,
            path_points=[[x, y] for x, y in way.points],
        )
        if started is not None:
            trial.started = started
        if ticks is not None:
            close_run(self.db, run, ticks, 0)
        return trial if end is None else finish_trial(self.db, trial.id, end, measures)

    def course(
        self,
        patient: Patient | int,
        plan: FloorPlan,
        sessions: Sequence[Sequence[dict[str, Any]]],
        source: Source = SIMULATED,
    ) -> list[int]:
        """Store the trials of each session by their measures, as if they were driven on earlier days; return their ids.

        The last session was a day ago, each one before it a week earlier.
        """
        patient_id = patient if isinstance(patient, int) else patient.id
        morning = utc_now().astimezone().replace(hour=9, minute=0)
        ids: list[int] = []
        for place, trials in enumerate(sessions):
            day = morning - timedelta(days=1 + 7 * (len(sessions) - 1 - place))
            session = self.session(patient_id, started=day, ended=day)
            if place == 0:
                self.map(session, make_parameters())
            for measures in trials:
                run = f"course-{patient_id}-{len(ids)}"
                end = "goal" if measures["reached"] else "time-out"
                started = day + timedelta(minutes=2 * len(ids))
                ids.append(
                    self.trial(session, measures, plan=plan, source=source, run=run, end=end, started=started).id
                )
        return ids

    def chair(self, name: str = "Red", host: str = "chair.example") -> PairedChair:
        """Return the clinic's real chair, which is paired unless there is one."""
        paired = chairs_of(self.db)
        return paired[0] if paired else add_chair(self.db, self.clinic, name, host, 5354, 7, HIGHEST_SPEEDS)

    def drive(
        self, session: PatientSession, end: str | None = None, distance: float | None = None, run: str = ""
    ) -> Drive:
        """Store a drive of the real chair; it goes on unless `end` says how it ended, after `distance` (m)."""
        run = run or uuid.uuid4().hex
        row = self.parameters(session)
        drive = add_drive(
            self.db,
            run=add_run(self.db, run, session.id, "drive", run, REAL),
            patient_id=session.patient_id,
            chair_id=self.chair().id,
            parameters_id=row.id,
            digest=row.hash,
        )
        return drive if end is None else finish_drive(self.db, drive.id, end, distance)


def plan_at(name: str) -> FloorPlan:
    """Return a floor plan that comes with the software."""
    plan = find_place(name)
    assert isinstance(plan, FloorPlan)
    return plan


@contextmanager
def rows_in(place: Database | Settings, name: str = "Clinic") -> Iterator[ClinicRows]:
    """Build in one transaction, in a database that is open or in that of a state folder."""
    if isinstance(place, Database):
        with place.transaction() as db:
            yield ClinicRows(db, name)
        return
    database = Database(place.database)
    try:
        with database.transaction() as db:
            yield ClinicRows(db, name)
    finally:
        database.close()
