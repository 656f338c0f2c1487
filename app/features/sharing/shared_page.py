"""What a share link opens: a PIN gives the browser a cookie, with which it reads one patient's records for an hour."""

from dataclasses import dataclass
from typing import Annotated, Any

from fastapi import APIRouter, Depends, HTTPException, Request, Response
from fastapi.concurrency import run_in_threadpool
from pydantic import Field

from app.api.deps import Db, ForEveryone, HashingPart, LivePart, SignInLimitsPart
from app.api.driving.clinic_places import ClinicPlaces
from app.api.page_session import any_session
from app.api.parts import parts_for
from app.api.replay.trajectories import MOST_TRAJECTORIES, Trajectories, TrialLine
from app.api.sign_in.cookies import read_cookie, set_cookie
from app.api.sign_in.hashing import Busy
from app.api.sign_in.passwords import BUSY, BUSY_FOR
from app.api.sign_in.sign_in_limits import address_of
from app.computing_process import ComputingProcess
from app.features.sharing.attention import tasks_of
from app.features.sharing.routes import news_of_shares
from app.features.sharing.service import (
    VISIT,
    SharedRecords,
    begin_visit,
    count_try,
    find_visit,
    take_back_try,
)
from app.features.sharing.stories import StoryView, story_view
from app.quantities import Document, Line
from app.scoring.learning import learning_curves
from app.scoring.measures import TRIAL_MEASURES, Word
from app.scoring.verdict.verdicts import task_verdicts
from app.session.clinic_spread import ClinicSpread, Task
from app.session.runs import SessionRuns
from app.source import SourceGroup
from app.store.access.visible_patients import VISIBLE_PATIENTS, every_patient
from app.store.database import Database
from app.store.learning_trials import CountedTrial, counted_trials
from app.store.log import write_log
from app.store.patients import find_session, sessions_of
from app.store.tables import Patient
from app.texts import Text
from app.world.path_titles import path_title

router = APIRouter(prefix="/shared", tags=["sharing"], dependencies=[ForEveryone])

COOKIE = "bodydrive_share"
COOKIE_PATH = "/api/v1/shared"
MOST_SESSIONS = 40  # the newest, of a course

WRONG = Text("sharing-wrong-pin")
NO_VISIT = Text("sharing-no-pin")


class TaskLearning(Document):
    """Trials of one patient on one path with one kind of source."""

    floorplan_title: Text
    path_name: str
    path_title: Text  # its name where the floor plan has no such path any more
    source: SourceGroup
    trials: list[dict[str, Any]]
    curves: dict[str, Any]
    words: dict[str, Word]  # measure -> verdict word on the newest session against the one before
    path: list[tuple[float, float]]
    trajectories: list[TrialLine]


@dataclass(frozen=True, slots=True)
class SharedLearning:
    """What the page of a share link says about the learning of its patient."""

    database: Database
    computing: ComputingProcess
    runs: SessionRuns
    trajectories: Trajectories
    spread: ClinicSpread
    places: ClinicPlaces

    def of_patient(self, patient_id: int, session_id: int | None) -> list[TaskLearning]:
        """Return what a patient drove, by task; with a session, its trials only, and verdicts up to it."""
        task_views = []
        with self.database.reading() as db:
            tasks = tasks_of(db, patient_id)
            counted = {task: counted_trials(db, patient_id, task[0], task[1]) for task in tasks}
        for (floorplan, path, source), every in counted.items():
            trials = [trial for trial in every if trial.group == source]
            shown = [trial for trial in trials if session_id is None or trial.trial.session_id == session_id]
            if shown:
                until = [trial for trial in trials if trial.session <= shown[-1].session]
                task_views.append(self._of_task(Task(floorplan, path, source), patient_id, shown, until))
        return task_views

    def _of_task(
        self, task: Task, patient_id: int, shown: list[CountedTrial], until: list[CountedTrial]
    ) -> TaskLearning:
        rows = [counted.row() for counted in shown]
        clinic = self.spread.of_others(task, patient_id)
        compared = self.computing.ask(task_verdicts, [counted.row() for counted in until], clinic, ()).sessions
        verdicts = compared[0].verdicts if compared else {}
        newest = [counted.trial for counted in shown[-MOST_TRAJECTORIES:]]
        recordings = [(trial.number, self.runs.folder_of(trial.run_id)) for trial in newest]
        return TaskLearning(
            floorplan_title=newest[-1].place_title,
            path_name=task.path,
            path_title=path_title(self.places.folder, task.floorplan, task.path),
            source=task.group,
            trials=rows,
            curves=self.computing.ask(learning_curves, rows, tuple(TRIAL_MEASURES), clinic),
            words={name: verdict.word for name, verdict in verdicts.items() if verdict.word != "number"},
            path=[(x, y) for x, y in newest[-1].path_points],
            trajectories=self.trajectories.lines(recordings),
        )


Learning = Annotated[SharedLearning, Depends(parts_for(SharedLearning))]


class OpenShare(Document):
    """The token of a link, and its PIN."""

    token: Annotated[Line, Field(min_length=1, max_length=128)]
    pin: Annotated[Line, Field(min_length=4, max_length=12)]


class SharedView(Document):
    """One session, or the course of a patient."""

    code: str
    is_course: bool
    expires: str
    stories: list[StoryView]  # the newest session first
    tasks: list[TaskLearning]


@router.post("/open", status_code=204)
@any_session("It reads what one link shares, and changes nothing of a session.")
async def open_share(
    body: OpenShare,
    request: Request,
    response: Response,
    database: Db,
    hashing: HashingPart,
    sign_in_limits: SignInLimitsPart,
    live: LivePart,
) -> None:
    """Let a browser read what a link shares, when the PIN is right; each try is counted before it is checked.

    For everybody: a cookie for one hour, for `/api/v1/shared` only, which names the patient by the code.
    """
    attempt = await sign_in_limits.code(address_of(request))
    share = await run_in_threadpool(_count, database, body.token)
    if share is None:
        raise HTTPException(401, str(WRONG))
    share_id, patient_id, pin_hash = share
    try:
        async with hashing.slot():
            is_right = await hashing.matches(pin_hash, body.pin)
    except Busy:
        attempt.take_back()
        await run_in_threadpool(_take_back, database, share_id)
        await sign_in_limits.refuse(503, BUSY, BUSY_FOR)
    token = await run_in_threadpool(_note, database, share_id, patient_id, is_right=is_right)
    live.notify(news_of_shares(patient_id))
    if token is None:
        raise HTTPException(401, str(WRONG))
    attempt.take_back()
    seconds = int(VISIT.total_seconds())
    set_cookie(request, response, COOKIE, token, COOKIE_PATH, max_age=seconds, samesite="strict")


@router.get("")
def shared(
    request: Request,
    database: Db,
    learning: Learning,
) -> SharedView:
    """Return all that a link shares, for the browser in which its PIN was given."""
    visit = _visit(database, request)
    before = VISIBLE_PATIENTS.set(frozenset({visit.patient_id}))  # from here, no other patient exists
    try:
        with database.transaction(closing=True) as db:
            write_log(db, None, "share viewed", share=visit.share_id, patient=visit.patient_id)
            if visit.session_id is None:
                sessions = sessions_of(db, visit.patient_id)[:MOST_SESSIONS]
            else:
                sessions = [find_session(db, visit.session_id)]
            stories = [story_view(db, session) for session in sessions]
            code = db.get_one(Patient, visit.patient_id).code
        tasks = learning.of_patient(visit.patient_id, visit.session_id)
    finally:
        VISIBLE_PATIENTS.reset(before)
    return SharedView(
        code=code,
        is_course=visit.session_id is None,
        expires=visit.expires.isoformat(),
        stories=stories,
        tasks=tasks,
    )


def _visit(database: Database, request: Request) -> SharedRecords:
    """Return what the browser may read; 401 when it may read nothing, or nothing any more."""
    token = read_cookie(request, COOKIE, COOKIE_PATH)
    with every_patient(), database.reading() as db:
        before = find_visit(db, token) if token else None
    if before is None:
        raise HTTPException(401, str(NO_VISIT))
    return before


def _count(database: Database, token: str) -> tuple[int, int, str] | None:
    with every_patient(), database.transaction(closing=True) as db:
        link = count_try(db, token)
        return None if link is None else (link.id, link.patient_id, link.pin_hash)


def _take_back(database: Database, share_id: int) -> None:
    with every_patient(), database.transaction(closing=True) as db:
        take_back_try(db, share_id)


def _note(database: Database, share_id: int, patient_id: int, *, is_right: bool) -> str | None:
    with every_patient(), database.transaction(closing=True) as db:
        token = begin_visit(db, share_id) if is_right else None
        what = "share refused" if token is None else "share opened"
        write_log(db, None, what, share=share_id, patient=patient_id)
        return token
