"""Comments on moments of trials: what the feature gives to the rest of the program."""

from collections import defaultdict
from collections.abc import Iterator
from typing import Any, Final

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.features.comments.service import Comment, comments_of
from app.features.comments.tables import CommentReading, CommentRevision, MomentComment
from app.features.registration import ArchivedTable, Attention, Feature, StoryEvent
from app.quantities import Line, Seconds
from app.store.access.person_tables import Person
from app.store.tables import PatientSession


def story(db: Session, session: PatientSession) -> Iterator[StoryEvent]:
    """Yield the comments on trials of a session."""
    for comment in comments_of(db, session_id=session.id):
        facts = {"id": comment.id, "trial": comment.trial_id, "number": comment.number, "t": comment.t}
        yield StoryEvent(comment.revised or comment.written, "comment", comment.person, comment.text, facts)


def attention(db: Session, person_id: int) -> Iterator[tuple[int, Attention]]:
    """Yield the patients of whose trials a person has comments to read."""
    unread: dict[int, list[Comment]] = defaultdict(list)
    for comment in comments_of(db, not_read_by=person_id):
        unread[comment.patient_id].append(comment)
    for patient, comments in unread.items():
        newest = comments[-1]
        yield patient, Attention("comment", len(comments), newest.session_id, newest.trial_id)


def remarks(db: Session, patient_id: int) -> list[Comment]:
    """Return the comments on trials of a patient."""
    return comments_of(db, patient_id=patient_id)


def name_authors(db: Session, rows: list[dict[str, Any]]) -> None:
    """Write the name of each comment's author into its row: another clinic does not have the person."""
    names = {person: name for person, name in db.execute(select(Person.id, Person.name))}  # noqa: C416  (typed rows)
    for row in rows:
        row["author"] = row["author"] or names[row["person_id"]]


FEATURE: Final = Feature(
    tables=(MomentComment, CommentRevision, CommentReading),
    routes=("routes",),
    archived=(
        ArchivedTable(
            MomentComment,
            by="trial_id",
            forms={"author": Line, "t": Seconds},
            complete=name_authors,
        ),
        ArchivedTable(CommentRevision, by="comment_id"),
    ),
    not_archived={"comment_reading": "who of this clinic has read a comment; in another clinic nobody has"},
    story=story,
    attention=attention,
    remarks=remarks,
)
