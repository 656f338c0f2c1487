"""Comments on a moment of a trial: written, revised or withdrawn by the author only, and read by each person."""

from dataclasses import dataclass
from datetime import datetime

from sqlalchemy import exists, func, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.features.comments.tables import CommentReading, CommentRevision, MomentComment
from app.refusals import Conflict
from app.store.access.person_tables import Person
from app.store.own_rows import own_row
from app.store.patients import find_patient
from app.store.tables import Patient, Trial
from app.texts import Text

MOST_COMMENTS = 200  # of one trial


@dataclass(frozen=True, slots=True)
class Comment:
    """The newest revision of a comment."""

    id: int
    trial_id: int
    patient_id: int
    session_id: int
    floorplan_title: Text | str  # of the trial
    number: int  # of the trial
    person_id: int | None  # None: its author belongs to another clinic
    person: str
    t: float  # s on the time line of the trial
    text: str
    revision_id: int
    written: datetime  # of its first revision
    revised: datetime | None  # of its newest one; None: there is only one
    withdrawn: datetime | None


def find_comment(db: Session, comment_id: int) -> MomentComment:
    """Return one of the clinic's comments; its patient is visible and not deleted."""
    comment = own_row(db, MomentComment, comment_id, Text("comments-missing", number=comment_id))
    find_patient(db, db.get_one(Trial, comment.trial_id).patient_id)
    return comment


def comments_of(
    db: Session,
    *,
    trial_id: int | None = None,
    session_id: int | None = None,
    patient_id: int | None = None,
    not_read_by: int | None = None,
) -> list[Comment]:
    """Return the comments of a trial, a session, a patient or a clinic, by their trials and moments.

    Comments that were withdrawn are left out; with a person in `not_read_by`, also this person's own ones, and those
    whose newest revision this person has read.
    """
    of_comment = CommentRevision.comment_id == MomentComment.id
    first = select(func.min(CommentRevision.id)).where(of_comment).correlate(MomentComment).scalar_subquery()
    newest = select(func.max(CommentRevision.id)).where(of_comment).correlate(MomentComment).scalar_subquery()
    written = select(CommentRevision.written).where(CommentRevision.id == first).scalar_subquery()
    query = (
        select(MomentComment, CommentRevision, written, func.coalesce(MomentComment.author, Person.name), Trial)
        .join(CommentRevision, CommentRevision.id == newest)
        .outerjoin(Person, Person.id == MomentComment.person_id)
        .join(Trial, Trial.id == MomentComment.trial_id)
        .join(Patient, Patient.id == Trial.patient_id)
        .where(MomentComment.withdrawn.is_(None), Patient.deleted.is_(None))
        .order_by(Trial.id, MomentComment.t, MomentComment.id)
    )
    for column, value in (
        (Trial.id, trial_id),
        (Trial.session_id, session_id),
        (Trial.patient_id, patient_id),
    ):
        if value is not None:
            query = query.where(column == value)
    if not_read_by is not None:
        is_read = exists().where(
            CommentReading.person_id == not_read_by,
            CommentReading.comment_id == MomentComment.id,
            CommentReading.revision_id == CommentRevision.id,
        )
        query = query.where(MomentComment.person_id.is_distinct_from(not_read_by), ~is_read)
    return [
        Comment(
            id=comment.id,
            trial_id=trial.id,
            patient_id=trial.patient_id,
            session_id=trial.session_id,
            floorplan_title=trial.place_title,
            number=trial.number,
            person_id=comment.person_id,
            person=name,
            t=comment.t,
            text=revision.text,
            revision_id=revision.id,
            written=begun,
            revised=revision.written if revision.written != begun else None,
            withdrawn=comment.withdrawn,
        )
        for comment, revision, begun, name, trial in db.execute(query)
    ]


def comment_history(db: Session, comment_id: int) -> list[CommentRevision]:
    """Return all revisions of a comment, the oldest first; they stay when it is withdrawn."""
    query = select(CommentRevision).where(CommentRevision.comment_id == comment_id)
    return list(db.scalars(query.order_by(CommentRevision.id)))


def add_comment(db: Session, trial: Trial, person_id: int, t: float, text: str) -> MomentComment:
    """Write a comment on a moment (s) of a trial; its author has read it."""
    if len(comments_of(db, trial_id=trial.id)) >= MOST_COMMENTS:
        raise Conflict(Text("comments-most", count=MOST_COMMENTS))
    comment = MomentComment(
        clinic_id=trial.clinic_id, trial_id=trial.id, person_id=person_id, author=None, t=round(t, 3), withdrawn=None
    )
    db.add(comment)
    db.flush()
    _revise(db, comment, text)
    return comment


def revise_comment(db: Session, comment: MomentComment, person_id: int, text: str) -> bool:
    """Give a comment another text, and return whether it differs; the text before stays in its history."""
    _require_author(comment, person_id)
    if comment_history(db, comment.id)[-1].text == text:
        return False
    _revise(db, comment, text)
    return True


def withdraw_comment(db: Session, comment: MomentComment, person_id: int) -> None:
    """Withdraw a comment: it is shown no longer, and its history stays."""
    _require_author(comment, person_id)
    comment.withdrawn = utc_now()
    db.flush()


def mark_read(db: Session, trial_id: int, person_id: int) -> None:
    """Store that a person has read the comments of a trial as they are now."""
    for comment in comments_of(db, trial_id=trial_id):
        db.merge(CommentReading(comment_id=comment.id, person_id=person_id, revision_id=comment.revision_id))
    db.flush()


def _revise(db: Session, comment: MomentComment, text: str) -> None:
    db.add(CommentRevision(comment_id=comment.id, text=text, written=utc_now()))
    db.flush()


def _require_author(comment: MomentComment, person_id: int) -> None:
    if comment.person_id != person_id:
        raise Conflict(Text("comments-not-author"))
    if comment.withdrawn is not None:
        raise Conflict(Text("comments-withdrawn-already"))
