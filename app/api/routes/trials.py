"""Trials along the paths of floor plans."""

import asyncio
from contextlib import suppress
from typing import Annotated, Any, Literal

from fastapi import APIRouter, Query
from pydantic import ConfigDict, Field

from app.api.answers import Answer, MomentText, OriginView
from app.api.deps import (
    Anyone,
    ChairsPart,
    Clinician,
    ControlPart,
    Db,
    LivePart,
    PicturesPart,
    PlacesPart,
    QualitiesPart,
    RowId,
    RunsPart,
    SessionFlowPart,
    TrajectoriesPart,
    TrialFlowPart,
    ViewKeeperPart,
)
from app.api.driving.places import needed_plan
from app.api.live.live_picture import ClinicLive
from app.api.live.screen_pictures import NO_PICTURE, Picture
from app.api.live.screen_socket import ScreenWord
from app.api.live.screens import Screen
from app.api.one_controller import Authority
from app.api.page_session import OWN_NAME, ClinicianInSession, any_session
from app.api.routes.source_view import SourceView
from app.api.sign_in.identity import SignedInPerson
from app.news import News
from app.quantities import Count, Document, Line, Name
from app.refusals import Conflict, NotFound, Unavailable
from app.scoring.control_quality import ControlQuality
from app.session.run_watch import Starter
from app.store.database import Database, Transaction
from app.store.learning_trials import compared_trials
from app.store.log import log_viewing, write_log
from app.store.origins import Origin, PatientImport, origin_of, origins_of
from app.store.patients import find_patient
from app.store.runs import find_trial, keep_trial, trials_of
from app.store.tables import PatientSession, Trial
from app.texts import Text

router = APIRouter(tags=["trials"])


class NewTrial(Document):
    """Where to drive, the screen that must stay in view meanwhile, and its picture; None: not reported."""

    floorplan: Name
    path: Name
    screen: ScreenWord
    picture: Picture | None = None


class EndTrial(Document):
    """Why a person ends a trial.

    `stops`: the count of stops that they had seen in a halted trial. The stop ends with the trial; a further one stays.
    """

    reason: Literal["by hand"] = "by hand"
    stops: Count | None = None


class Discard(Document):
    """Why a trial does not count."""

    reason: Annotated[Line, Field(min_length=1, max_length=200)]


class TrialView(Answer):
    """A trial and its measures."""

    model_config = ConfigDict(populate_by_name=True)

    id: int
    number: int
    patient_id: int
    floorplan: str
    floorplan_title: Text = Field(validation_alias="place_title")
    path: str
    started: MomentText
    status: str
    end: str | None
    kept: bool
    discard_reason: Text | None
    source: SourceView
    measures: dict[str, Any] | None
    origin: OriginView | None = None  # null: driven in this clinic


class ListedTrial(TrialView):
    """A trial beside all others of its patient."""

    compared_in: int | None  # id of its session; null: no verdict compares it


class TrajectoryView(Answer):
    """The trajectory of the chair, decimated."""

    t: list[float]
    x: list[float]
    y: list[float]


class TrialDetail(Document):
    """A trial with its trajectory (null when the recording is gone) and the path's points at the time of the trial."""

    id: int
    number: int
    patient_id: int
    patient_code: str
    session_number: int  # 1, 2, 3 ... per patient
    floorplan: str
    floorplan_title: Text
    path: list[tuple[float, float]]
    path_name: str
    started: MomentText
    status: str
    end: str | None
    kept: bool
    discard_reason: Text | None
    source: SourceView
    measures: dict[str, Any] | None
    origin: OriginView | None  # null: driven in this clinic
    trajectory: TrajectoryView | None
    quality: ControlQuality | None  # None when the recording cannot be read


@router.post("/trials", status_code=201)
async def start_trial(
    body: NewTrial,
    person: ClinicianInSession,
    *,
    database: Db,
    trial_flow: TrialFlowPart,
    chairs: ChairsPart,
    session_flow: SessionFlowPart,
    pictures: PicturesPart,
    view_keeper: ViewKeeperPart,
    places: PlacesPart,
) -> TrialView:
    """Start a trial: the chair is put on the start, the recording begins, and the chair is armed.

    `screen`: the random word of the page on the screen socket; `picture`: what it shows to drive by (null: not said),
    kept in `meta`. 409 with a real chair chosen, for `none`, and while this screen or one of the patient's has no
    picture.
    """
    async with session_flow.undisturbed():
        session = await session_flow.needed_session()
        if chairs.chosen is not None:
            raise Conflict(Text("api-trial-on-real-chair"))
        refusal = NO_PICTURE if body.picture == "none" else pictures.refusal(Screen(person.person_id, body.screen))
        if refusal is not None:
            raise Conflict(refusal)
        plan = await asyncio.to_thread(needed_plan, places, body.floorplan)
        try:
            path = plan.path_named(body.path)
        except ValueError as error:
            raise NotFound(Text("api-no-path", name=body.path)) from error
        obstacle = await session_flow.load_parameters()
        if obstacle is not None:
            raise Conflict(obstacle)
        await view_keeper.show(plan, path.name)
        trial_id = await trial_flow.start(
            session, Starter(person.person_id, person.name, body.screen, body.picture), plan, path
        )
    return await asyncio.to_thread(_one, database, trial_id)


def _one(database: Database, trial_id: int) -> TrialView:
    with database.reading() as db:
        return _view(db, find_trial(db, trial_id))


def _view(db: Transaction, trial: Trial) -> TrialView:
    return _from(origin_of(db, trial.session_id), TrialView.of(trial))


def _from(origin: PatientImport | Origin | None, view: TrialView) -> TrialView:
    return view if origin is None else view.model_copy(update={"origin": OriginView.of(origin)})


@router.post("/trials/current/end")
async def end_trial(
    body: EndTrial,
    person: ClinicianInSession,
    authority: Authority,
    database: Db,
    control: ControlPart,
    trial_flow: TrialFlowPart,
) -> TrialView:
    """End the trial by hand; answered when it has been measured."""
    authority.require_controller(person)
    trial_id = await trial_flow.end()
    if body.stops is not None:
        # After the run: within it, clearing a stop would begin the check for rest. A stop that stays is in the picture.
        with suppress(Conflict, Unavailable):
            await control.call("clear", stops=body.stops)
    return await asyncio.to_thread(_one, database, trial_id)


@router.get("/trials")
def list_trials(patient: Annotated[int, Query(ge=1, le=2**31)], person: Anyone, database: Db) -> list[ListedTrial]:
    """List a patient's trials, the newest last.

    `status` is `running` or `done`, `end` is `goal`, `time-out`, `by hand` or `fault`. `compared_in`: id of the trial's
    session, null where no verdict compares it (discarded, not measured, one of the first three of its task and kind of
    source).
    """
    with database.transaction(closing=True) as db:
        find_patient(db, patient)
        log_viewing(db, person.name, patient)
        origins = origins_of(db, patient)
        trials = trials_of(db, patient)
        compared = compared_trials(trials)
        views = [_from(origins.get(trial.session_id), TrialView.of(trial)) for trial in trials]
        return [
            ListedTrial(**dict(view), compared_in=trial.session_id if trial.id in compared else None)
            for trial, view in zip(trials, views, strict=True)
        ]


@router.get("/trials/{trial_id}")
def one_trial(
    trial_id: RowId,
    person: Anyone,
    database: Db,
    runs: RunsPart,
    trajectories: TrajectoriesPart,
    qualities: QualitiesPart,
) -> TrialDetail:
    """Return a trial with its trajectory over its path."""
    with database.transaction(closing=True) as db:
        trial = find_trial(db, trial_id)
        write_log(db, person.name, "trial viewed", trial=trial_id)
        view = _view(db, trial)
        code = find_patient(db, trial.patient_id).code
        session_number = db.get_one(PatientSession, trial.session_id).number
    trajectory = trajectories.of(runs.folder_of(trial.run_id)) if trial.status == "done" else None
    shown = view.model_dump(exclude={"path"})
    return TrialDetail(
        **shown,
        patient_code=code,
        session_number=session_number,
        path=[(x, y) for x, y in trial.path_points],
        path_name=trial.path,
        trajectory=None if trajectory is None else TrajectoryView.of(trajectory),
        quality=qualities.of(trial),
    )


@router.post("/trials/{trial_id}/discard")
@any_session(OWN_NAME)
async def discard_trial(trial_id: RowId, body: Discard, person: Clinician, database: Db, live: LivePart) -> TrialView:
    """Discard a trial: it counts in no curve or figure; it can be kept again."""
    return await _keep(database, live, person, trial_id, body.reason)


@router.post("/trials/{trial_id}/keep")
@any_session(OWN_NAME)
async def keep_again(trial_id: RowId, person: Clinician, database: Db, live: LivePart) -> TrialView:
    """Let a discarded trial count again."""
    return await _keep(database, live, person, trial_id, None)


async def _keep(
    database: Database, live: ClinicLive, person: SignedInPerson, trial_id: int, reason: str | None
) -> TrialView:
    def _write() -> tuple[TrialView, News]:
        with database.transaction() as db:
            trial = keep_trial(db, trial_id, reason)
            write_log(db, person.name, "trial kept" if reason is None else "trial discarded", trial=trial_id)
            news = News(what="trial", patient=trial.patient_id, session=trial.session_id, trial=trial_id)
            return _view(db, trial), news

    stored, news = await asyncio.to_thread(_write)
    live.notify(news)
    return stored
