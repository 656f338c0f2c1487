"""Comments on a moment of a trial: the only thing that a reviewer may change, and only their own ones."""

from typing import Annotated

from fastapi import APIRouter, Query
from pydantic import Field

from app.api.answers import Answer, MomentText
from app.api.deps import Anyone, Db, LivePart, RowId
from app.api.page_session import LOOKS, OWN_NAME, any_session
from app.api.sign_in.identity import SignedInPerson
from app.features.comments.service import (
    Comment,
    add_comment,
    comment_history,
    comments_of,
    find_comment,
    mark_read,
    revise_comment,
    withdraw_comment,
)
from app.news import News
from app.quantities import Document, Note
from app.refusals import NotFound
from app.store.database import Transaction
from app.store.log import log_viewing, write_log
from app.store.patients import find_patient
from app.store.runs import find_trial
from app.store.tables import Trial
from app.texts import Text

router = APIRouter(tags=["review"])

CommentText = Annotated[Note, Field(min_length=1, max_length=2000, pattern=r"\S")]


class NewComment(Document):
    """A comment on a moment (s) of a trial; the time line is negative before motion was permitted."""

    t: Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-86_400, le=86_400)]
    text: CommentText


class RevisedComment(Document):
    """Another text of a comment."""

    text: CommentText


class CommentRevisionView(Answer):
    """One text of a comment."""

    text: str
    written: MomentText


class CommentView(Document):
    """A comment on a moment, with all its texts, the newest first."""

    id: int
    trial_id: int
    number: int  # of the trial
    patient_id: int
    session_id: int
    person: str
    is_own: bool
    t: float
    revisions: list[CommentRevisionView]
    unread: bool


@router.get("/comments")
def unread_comments(
    person: Anyone, database: Db, patient: Annotated[int | None, Query(ge=1, le=2**31)] = None
) -> list[CommentView]:
    """List the comments that the person who asks has not read, of all patients or of one."""
    with database.transaction(closing=True) as db:
        if patient is not None:
            find_patient(db, patient)
        unread = comments_of(db, patient_id=patient, not_read_by=person.person_id)
        for patient_id in dict.fromkeys(comment.patient_id for comment in unread):
            log_viewing(db, person.name, patient_id)
        return [_view(db, comment, person, unread=True) for comment in unread]


@router.get("/trials/{trial_id}/comments")
def list_comments(trial_id: RowId, person: Anyone, database: Db) -> list[CommentView]:
    """List the comments of a trial by their moments."""
    with database.transaction(closing=True) as db:
        trial = _trial(db, trial_id)
        log_viewing(db, person.name, trial.patient_id)
        return _views(db, trial, person)


@router.post("/trials/{trial_id}/comments", status_code=201)
@any_session(OWN_NAME)
def new_comment(trial_id: RowId, body: NewComment, person: Anyone, database: Db, live: LivePart) -> list[CommentView]:
    """Write a comment on a moment of a trial.

    `t` is negative before motion was permitted.
    """
    with database.transaction() as db:
        trial = _trial(db, trial_id)
        comment = add_comment(db, trial, person.person_id, body.t, body.text)
        write_log(db, person.name, "comment added", patient=trial.patient_id, trial=trial_id, comment=comment.id)
        answer, news = _views(db, trial, person), _news_of(trial)
    live.notify(news)
    return answer


@router.post("/trials/{trial_id}/comments/read", status_code=204)
@any_session(LOOKS)
def mark_comments_read(trial_id: RowId, person: Anyone, database: Db) -> None:
    """Store that the person who asks has read the comments of a trial."""
    with database.transaction() as db:
        mark_read(db, _trial(db, trial_id).id, person.person_id)


@router.put("/comments/{comment_id}")
@any_session(OWN_NAME)
def new_comment_text(
    comment_id: RowId, body: RevisedComment, person: Anyone, database: Db, live: LivePart
) -> list[CommentView]:
    """Give a comment of one's own another text; the text before stays in its history."""
    with database.transaction() as db:
        comment = find_comment(db, comment_id)
        trial = db.get_one(Trial, comment.trial_id)
        if revise_comment(db, comment, person.person_id, body.text):
            write_log(db, person.name, "comment revised", patient=trial.patient_id, trial=trial.id, comment=comment_id)
        answer, news = _views(db, trial, person), _news_of(trial)
    live.notify(news)
    return answer


@router.delete("/comments/{comment_id}")
@any_session(OWN_NAME)
def no_comment(comment_id: RowId, person: Anyone, database: Db, live: LivePart) -> list[CommentView]:
    """Withdraw a comment of one's own; its history stays."""
    with database.transaction() as db:
        comment = find_comment(db, comment_id)
        trial = db.get_one(Trial, comment.trial_id)
        withdraw_comment(db, comment, person.person_id)
        write_log(db, person.name, "comment withdrawn", patient=trial.patient_id, trial=trial.id, comment=comment_id)
        answer, news = _views(db, trial, person), _news_of(trial)
    live.notify(news)
    return answer


def _trial(db: Transaction, trial_id: int) -> Trial:
    trial = find_trial(db, trial_id)
    find_patient(db, trial.patient_id)
    if trial.status != "done":
        raise NotFound(Text("comments-trial-running"))
    return trial


def _news_of(trial: Trial) -> News:
    return News(what="comment", patient=trial.patient_id, session=trial.session_id, trial=trial.id)


def _views(db: Transaction, trial: Trial, person: SignedInPerson) -> list[CommentView]:
    unread = {comment.id for comment in comments_of(db, trial_id=trial.id, not_read_by=person.person_id)}
    return [_view(db, comment, person, unread=comment.id in unread) for comment in comments_of(db, trial_id=trial.id)]


def _view(db: Transaction, comment: Comment, person: SignedInPerson, *, unread: bool) -> CommentView:
    return CommentView(
        id=comment.id,
        trial_id=comment.trial_id,
        number=comment.number,
        patient_id=comment.patient_id,
        session_id=comment.session_id,
        person=comment.person,
        is_own=comment.person_id == person.person_id,
        t=comment.t,
        revisions=[CommentRevisionView.of(row) for row in reversed(comment_history(db, comment.id))],
        unread=unread,
    )
