"""A session as a story, in one answer: what was done, what changed and what was said, in the order of time."""

from collections.abc import Iterator
from typing import Any

from fastapi import APIRouter
from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.api.answers import Answer, MomentText, OriginView
from app.api.deps import Anyone, Db, RowId
from app.features.records.service import session_record
from app.features.registration import EventKind, StoryEvent, features
from app.quantities import Document
from app.scoring.interruptions import interruptions_of
from app.store.database import Transaction
from app.store.interface_tests import interface_tests_of_session
from app.store.log import log_session_viewing
from app.store.origins import origin_of
from app.store.patients import find_session
from app.store.session_contents import drives_of_session, trials_of_session
from app.store.tables import LogEntry, ParameterSet, Patient, PatientSession, Profile, Run
from app.texts import Text

router = APIRouter(tags=["review"])
CALIBRATION = ("rest", "free", "prompt")  # kinds of its runs
STOPS = frozenset({"stop", "stop requested", "fault"})  # rows of the log


def story_of(db: Session, session: PatientSession) -> list[StoryEvent]:
    """Return the events of a session in time order."""
    more = (event for feature in features().values() for event in feature.story(db, session))
    every = (*_done(db, session), *_changes(db, session), *more)
    return sorted(every, key=lambda event: event.at)


def _done(db: Session, session: PatientSession) -> Iterator[StoryEvent]:
    yield StoryEvent(session.started, "begin", session.opened_by, session.goal, {"version": session.version})
    calibration = select(func.min(Run.started), func.count()).where(
        Run.session_id == session.id, Run.kind.in_(CALIBRATION)
    )
    begun, recordings = db.execute(calibration).one()
    if begun is not None:
        yield StoryEvent(begun, "calibration", None, "", {"recordings": recordings})
    for trial in trials_of_session(db, session.id):
        facts = {
            "id": trial.id,
            "number": trial.number,
            "path": trial.path,
            "end": trial.end,
            "kept": trial.kept,
            "discard_reason": None if trial.discard_reason is None else str(trial.discard_reason),
            "source": trial.run.source.group,
            **interruptions_of(trial.measures),
        }
        yield StoryEvent(trial.started, "trial", None, trial.place_title, facts)
    for test in interface_tests_of_session(db, session.id):
        facts = {"id": test.id, "number": test.number, "end": test.end, "source": test.run.source.group}
        yield StoryEvent(test.started, "test", None, "", facts)
    for drive in drives_of_session(db, session.id):
        facts = {"id": drive.id, "end": drive.end, "distance": drive.distance, "source": drive.run.source.group}
        yield StoryEvent(drive.started, "drive", None, "", facts)
    yield from _stops(db, session)
    if session.ended is not None:
        yield StoryEvent(session.ended, "end", None, "", {})


def _stops(db: Session, session: PatientSession) -> Iterator[StoryEvent]:
    """Yield the stops of a session: the log names no session, and one session at a time is open in a clinic.

    An imported session was held elsewhere: what this clinic's log has of its hours is of other patients.
    """
    if origin_of(db, session.id) is not None:
        return
    rows = select(LogEntry).where(LogEntry.at >= session.started, LogEntry.what.in_(STOPS))
    if session.ended is not None:
        rows = rows.where(LogEntry.at <= session.ended)
    for row in db.scalars(rows):
        yield StoryEvent(row.at, "stop", row.person, "", {"what": row.what})


def _changes(db: Session, session: PatientSession) -> Iterator[StoryEvent]:
    for map_version in db.scalars(select(Profile).where(Profile.session_id == session.id)):
        facts = {"version": map_version.version, "origin": map_version.origin}
        yield StoryEvent(map_version.created, "map", None, "", facts)
    until = ParameterSet.created <= session.ended if session.ended is not None else ParameterSet.id > 0
    sets = (
        select(ParameterSet, Profile.version)
        .join(Profile, Profile.id == ParameterSet.profile_id)
        .where(Profile.patient_id == session.patient_id, ParameterSet.created >= session.started, until)
    )
    for row, version in db.execute(sets):
        yield StoryEvent(row.created, "parameters", None, row.title, {"version": version, "hash": row.hash})


class EventView(Answer):
    """One thing that happened in a session, or was written about it."""

    at: MomentText
    kind: EventKind
    person: str | None
    text: Text
    facts: dict[str, Any]


class StoryScale(Answer):
    """The total of an outcome scale."""

    name: str
    total: float


class StoryView(Document):
    """A session in time order."""

    session_id: int
    number: int
    patient_id: int
    code: str
    goal: str
    scales: list[StoryScale]
    is_signed: bool
    origin: OriginView | None  # null: held in this clinic
    events: list[EventView]


def story_view(db: Transaction, session: PatientSession) -> StoryView:
    """Return a session as a story."""
    record = session_record(db, session.id)
    return StoryView(
        session_id=session.id,
        number=session.number,
        patient_id=session.patient_id,
        code=db.get_one(Patient, session.patient_id).code,
        goal=record.goal,
        scales=[StoryScale.of(scale) for scale in record.scales],
        is_signed=record.sign_off is not None,
        origin=None if (origin := origin_of(db, session.id)) is None else OriginView.of(origin),
        events=[EventView.of(event) for event in story_of(db, session)],
    )


@router.get("/sessions/{session_id}/story")
def story(session_id: RowId, person: Anyone, database: Db) -> StoryView:
    """Return what was done, changed and said in a session, in time order."""
    with database.transaction(closing=True) as db:
        session = find_session(db, session_id)
        log_session_viewing(db, person.name, session.patient_id, session_id)
        return story_view(db, session)
