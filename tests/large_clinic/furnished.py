"""Makes a clinic of some years: patients, sessions, calibrations, trials with recordings, and the log of it all.

The rows are those that the program writes, but many at a time. A few trials are driven through the chain and recorded;
the recording of every other trial is one of these, under another name (a hard link), so that the disk holds them once.
"""

import os
from collections.abc import Iterator, Sequence
from datetime import datetime, timedelta
from itertools import count
from pathlib import Path
from typing import Any, NamedTuple, get_args

import numpy as np
from large_clinic.written import written_rows
from recorded_trial import record_trial
from sqlalchemy import insert
from sqlalchemy.orm import Session

from app.calibration.vocabulary import DriveParameters
from app.clock import utc_now
from app.features.consents.service import give_consent
from app.file_modes import keep_new_files_private
from app.session.recordings import measure_recording, quality_of_recording
from app.settings import Settings, data_folder
from app.source import Source
from app.store.access.sign_ins import sign_in
from app.store.consent import Consent
from app.store.database import Database
from app.store.log_chain import FIRST, entry_hash
from app.store.people import add_clinic, add_person
from app.store.tables import LogEntry, ParameterSet, Patient, PatientSession, Profile, Run, Trial
from app.world.floorplan import FloorPlan, load_floorplan
from building import make_parameters, plan_of

PLANS = ("apartment", "clinic")
RECORDINGS = 12  # driven ones, at most
SECONDS = 60.0  # of each
SOURCE = Source(shirt="udp", body=None, chair="virtual", simulated=False)
CALIBRATE_EVERY = 5  # sessions
NOISE, LEARNING = 0.15, 0.4  # of a measure: of one trial, and from the first trial to the last


class Size(NamedTuple):
    """How large the clinic is."""

    patients: int = 200
    sessions: int = 20  # of each patient
    trials: int = 15  # of each session


class Recorded(NamedTuple):
    """A recording, and what the program stores of it."""

    folder: Path
    measures: dict[str, Any]
    quality: dict[str, Any]


def furnish_years(state: Path, size: Size) -> str:
    """Make the clinic in an empty folder and return the token of its owner's sign-in."""
    keep_new_files_private()
    settings = Settings(state=state)
    database = Database(settings.database)
    parameters = make_parameters()
    recorded = list(_recordings(settings.runs, parameters, min(RECORDINGS, size.trials)))
    plans = [load_floorplan(data_folder() / "floorplans" / f"{name}.json") for name in PLANS]
    with database.transaction() as db:
        clinic = add_clinic(db, "Many years")
        rows = _Rows(clinic.id, size, parameters, recorded, plans)
        for table, documents in rows.all().items():
            _insert(db, table, documents)
        _insert(db, LogEntry, _log_rows(rows.log))
        ada = add_person(db, clinic, "Ada", "owner", None)
        token = sign_in(db, ada, "large clinic")
        for table, documents in rows.written_by(ada.id).items():
            _insert(db, table, documents)
        for patient in rows.patients:
            for consent in get_args(Consent):
                give_consent(db, patient["id"], consent, patient["created"].date(), ada.name)
    _link(settings.runs, recorded, [row["id"] for row in rows.runs if row["kind"] == "drive"])
    database.close()
    return token


def _insert(db: Session, table: Any, documents: Sequence[dict[str, Any]]) -> None:
    for start in range(0, len(documents), 5000):
        db.execute(insert(table), documents[start : start + 5000])


def _recordings(folder: Path, parameters: DriveParameters, driven: int) -> Iterator[Recorded]:
    plan = plan_of()
    for number in range(driven):
        own = folder / f"recorded-{number}"
        record_trial(own, parameters, seconds=SECONDS, seed=number, plan=plan, source=SOURCE.model_dump())
        measures = {**measure_recording(own, plan, plan.paths[0]), "reached": True}
        yield Recorded(own, measures, quality_of_recording(own).model_dump(mode="json"))


def _link(folder: Path, recorded: Sequence[Recorded], runs: Sequence[str]) -> None:
    names = [[file.name for file in one.folder.iterdir()] for one in recorded]
    for place, run in enumerate(runs):
        own = folder / run
        own.mkdir()
        for name in names[place % len(recorded)]:
            os.link(recorded[place % len(recorded)].folder / name, own / name)


def _log_rows(entries: Sequence[tuple[datetime, str, dict[str, Any]]]) -> list[dict[str, Any]]:
    previous, rows = FIRST, []
    for at, what, details in sorted(entries, key=lambda entry: entry[0]):
        own = entry_hash(previous, at, "Ada", what, details)
        rows.append(
            {"at": at, "person": "Ada", "what": what, "details": details, "previous_hash": previous, "hash": own}
        )
        previous = own
    return rows


class _Rows:
    """The rows of each table, of one patient after the other."""

    def __init__(
        self,
        clinic_id: int,
        size: Size,
        parameters: DriveParameters,
        recorded: Sequence[Recorded],
        plans: Sequence[FloorPlan],
    ) -> None:
        self.log: list[tuple[datetime, str, dict[str, Any]]] = []
        self.patients: list[dict[str, Any]] = []
        self.sessions: list[dict[str, Any]] = []
        self.profiles: list[dict[str, Any]] = []
        self.sets: list[dict[str, Any]] = []
        self.runs: list[dict[str, Any]] = []
        self.trials: list[dict[str, Any]] = []
        self._clinic, self._size, self._recorded = clinic_id, size, recorded
        self._tasks = [(plan, path) for plan in plans for path in plan.paths][:3]
        self._settings = parameters.model_dump(mode="json", exclude={"profile"})
        self._profile = parameters.profile.model_dump(mode="json")
        self._hash = parameters.hash
        self._random = np.random.default_rng(1)
        self._session_ids, self._trial_ids = count(1), count(1)
        self._set_of: dict[int, int] = {}  # patient -> their newest parameter set
        begin = {patient: self._add_patient(patient) for patient in range(1, size.patients + 1)}
        for number in range(1, size.sessions + 1):  # as the clinic drove them: a week after the other
            for patient, first in begin.items():
                self._add_session(patient, number, first + timedelta(weeks=number - 1))

    def all(self) -> dict[Any, list[dict[str, Any]]]:
        """Return the documents of each table, in the order in which they refer to one another."""
        return {
            Patient: self.patients,
            PatientSession: self.sessions,
            Profile: self.profiles,
            ParameterSet: self.sets,
            Run: self.runs,
            Trial: self.trials,
        }

    def written_by(self, person_id: int) -> dict[Any, list[dict[str, Any]]]:
        """Return what was written and tested in the sessions, in the order in which the tables refer to one another."""
        return written_rows(self.sessions, self.trials, self._set_of, person_id, SOURCE.model_dump())

    def _add_patient(self, patient: int) -> datetime:
        begin = utc_now() - timedelta(weeks=self._size.sessions, hours=patient)
        self.patients.append(
            {
                "id": patient,
                "clinic_id": self._clinic,
                "code": f"P-{patient:04d}",
                "note": "",
                "created": begin,
                "pseudonym": f"Patient {patient:04d}",
                "adaptation": "off",
            }
        )
        self.log.append((begin, "patient added", {"patient": patient}))
        return begin

    def _add_session(self, patient: int, number: int, started: datetime) -> None:
        session = next(self._session_ids)
        self.sessions.append(
            {
                "id": session,
                "clinic_id": self._clinic,
                "patient_id": patient,
                "number": number,
                "started": started,
                "opened_by": "Ada",
                "ended": started + timedelta(hours=1),
                "accepted": True,
            }
        )
        self.log.append((started, "session opened", {"patient": patient, "session": session}))
        if (number - 1) % CALIBRATE_EVERY == 0:
            self._add_profile(patient, session, (number - 1) // CALIBRATE_EVERY + 1, started)
        for place in range(self._size.trials):
            moment = started + timedelta(minutes=10 + 3 * place)
            self._add_trial(patient, session, (number - 1) * self._size.trials + place, moment)

    def _add_profile(self, patient: int, session: int, version: int, moment: datetime) -> None:
        own = self._set_of[patient] = len(self.profiles) + 1
        self.profiles.append(
            {
                "id": own,
                "patient_id": patient,
                "session_id": session,
                "version": version,
                "origin": "calibration",
                "document": self._profile,
                "created": moment,
                "simulated": False,
            }
        )
        self.sets.append(
            {
                "id": own,
                "profile_id": own,
                "title": "Standard",
                "settings": self._settings,
                "hash": self._hash,
                "created": moment,
                "current": True,
                "abandoned": False,
            }
        )
        self.log.append((moment, "calibration accepted", {"patient": patient, "version": version}))

    def _add_trial(self, patient: int, session: int, place: int, started: datetime) -> None:
        own, (plan, path) = next(self._trial_ids), self._tasks[place % len(self._tasks)]
        run = f"run-{own}"
        of_all = self._size.sessions * self._size.trials
        level = 1 + LEARNING * float(np.exp(-4 * place / of_all)) + NOISE * float(self._random.normal())
        recorded = self._recorded[own % len(self._recorded)]
        measures = {
            name: value * level if isinstance(value, float) else value for name, value in recorded.measures.items()
        }
        self.runs.append(
            {
                "id": run,
                "session_id": session,
                "kind": "drive",
                "folder": run,
                "started": started,
                "ended": started + timedelta(seconds=SECONDS),
                "rows": int(100 * SECONDS),
                "dropped": 0,
                **SOURCE.model_dump(),
            }
        )
        self.trials.append(
            {
                "id": own,
                "clinic_id": self._clinic,
                "patient_id": patient,
                "session_id": session,
                "parameters_id": self._set_of[patient],
                "run_id": run,
                "number": place // len(self._tasks) + 1,
                "floorplan": plan.name,
                "floorplan_title": plan.title,
                "path": path.name,
                "path_points": [[x, y] for x, y in path.points],
                "started": started,
                "status": "done",
                "end": "goal",
                "kept": True,
                "measures": measures,
                "quality": recorded.quality,
            }
        )
        self.log.append((started, "trial started", {"trial": own}))
        self.log.append((started + timedelta(seconds=SECONDS), "trial ended", {"trial": own, "end": "goal"}))
