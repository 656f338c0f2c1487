"""A session as a story: what was done, what changed and what was said, in the order in which it happened."""

from collections.abc import Iterator
from datetime import datetime
from typing import Any, Literal, NamedTuple

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.scoring.interruptions import interruptions_of
from app.store.interface_tests import interface_tests_of_session
from app.store.records.imports import origin_of
from app.store.records.record_tables import NoteRevision, SessionNote
from app.store.records.session_contents import drives_of_session, trials_of_session
from app.store.records.sign_off import sign_off_history
from app.store.sharing.comments import comments_of
from app.store.tables import LogEntry, ParameterSet, PatientSession, Profile, Run

Kind = Literal[
    "begin",
    "calibration",
    "map",
    "parameters",
    "trial",
    "test",
    "stop",
    "drive",
    "note",
    "comment",
    "sign-off",
    "unlock",
    "end",
]
CALIBRATION = ("rest", "free", "prompt")  # kinds of its runs
STOPS = frozenset({"stop", "stop requested", "fault"})  # rows of the log


class StoryEvent(NamedTuple):
    """One thing that happened in a session, or was written about it."""

    at: datetime
    kind: Kind
    person: str | None  # who did or said it; None: not recorded
    words: str  # what was said, or a title; in the words of its author
    facts: dict[str, Any]  # by names that the page puts into words


def story_of(db: Session, session: PatientSession) -> list[StoryEvent]:
    """Return the events of a session in time order."""
    return sorted((*_done(db, session), *_changes(db, session), *_sayings(db, session)), key=lambda event: event.at)


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
            "discard_reason": trial.discard_reason,
            "simulated": trial.run.simulated,
            **interruptions_of(trial.measures),
        }
        yield StoryEvent(trial.started, "trial", None, trial.floorplan_title, facts)
    for test in interface_tests_of_session(db, session.id):
        facts = {"id": test.id, "number": test.number, "end": test.end, "simulated": test.run.simulated}
        yield StoryEvent(test.started, "test", None, "", facts)
    for drive in drives_of_session(db, session.id):
        facts = {"id": drive.id, "end": drive.end, "distance": drive.distance, "simulated": drive.run.simulated}
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


def _sayings(db: Session, session: PatientSession) -> Iterator[StoryEvent]:
    notes = select(NoteRevision).join(SessionNote, SessionNote.id == NoteRevision.note_id)
    newest = select(func.max(NoteRevision.id)).group_by(NoteRevision.note_id)
    for note in db.scalars(notes.where(SessionNote.session_id == session.id, NoteRevision.id.in_(newest))):
        yield StoryEvent(note.written, "note", note.person, note.text, {})
    for comment in comments_of(db, session_id=session.id):
        facts = {"id": comment.id, "trial": comment.trial_id, "number": comment.number, "t": comment.t}
        yield StoryEvent(comment.revised or comment.written, "comment", comment.person, comment.text, facts)
    for row in sign_off_history(db, session.id):
        yield StoryEvent(row.at, "sign-off", row.person, "", {})
        if row.unlocked is not None:
            yield StoryEvent(row.unlocked, "unlock", row.unlocked_by, row.reason or "", {})
