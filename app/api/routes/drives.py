"""Drives of the real chair: the summary before arming, arming, the end, the list."""

import asyncio
from typing import Annotated

from fastapi import APIRouter, HTTPException, Query
from fastapi.requests import Request
from pydantic import Field

from app.api.answers import Answer, MomentText
from app.api.deps import (
    Anyone,
    ArmingPart,
    ChairsPart,
    Db,
    DriveFlowPart,
    ScreensPart,
    SessionFlowPart,
)
from app.api.live.screen_socket import ScreenWord
from app.api.live.screens import Screen
from app.api.nearby import require_nearby
from app.api.one_controller import Authority
from app.api.page_session import ClinicianInSession
from app.api.routes.source_view import SourceView
from app.calibration.vocabulary import ControlMode
from app.clock import monotonic
from app.quantities import Document
from app.refusals import Conflict
from app.session.parameter_differences import Difference
from app.session.run_watch import Starter
from app.speed_limits import Speeds
from app.store.database import Database
from app.store.drives import drives_of, find_drive
from app.store.log import log_viewing
from app.store.patients import find_patient
from app.texts import Text

router = APIRouter(prefix="/drives", tags=["drives"])

HEARD_WITHIN = 1.0  # s since the screen's last report; once armed, the gate watches it more strictly
CHANGED = Text("api-controls-changed")
NOT_IN_VIEW = Text("api-not-in-view")


class ChairSummary(Answer):
    """A chair."""

    id: int
    name: str


class ParametersSummary(Answer):
    """A parameter set and its drive settings."""

    title: str
    hash: str
    mode_u1: ControlMode
    mode_u2: ControlMode
    cutoff: float  # Hz
    cruise_time: float  # s
    turn_cruise_time: float  # s


class PracticeView(Answer):
    """How often this very set was practised on the virtual chair, and when last."""

    trials: int
    last: MomentText | None


class LatestPractice(Answer):
    """The set that was practised last."""

    hash: str
    title: str


class Summary(Document):
    """What arming would apply; None for what is missing.

    `hash` is of the set and the chair document, whose first digits are `document`, empty where the chair has none;
    `crawls`: the chair misses its document, and drives at 0.3 m/s at most.
    """

    chair: ChairSummary | None
    parameters: ParametersSummary | None
    speeds: Speeds | None
    hash: str | None
    document: str
    crawls: bool
    practised: PracticeView
    last_practised: LatestPractice | None
    differences: list[Difference]
    refusals: list[Text | str]


class NewDrive(Document):
    """The hash of the summary that the person has read, and their screen."""

    hash: Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]
    screen: ScreenWord


class DriveView(Answer):
    """A drive."""

    id: int
    started: MomentText
    ended: MomentText | None
    hash: str
    distance: float | None  # m, None when it never moved
    end: str | None
    source: SourceView


@router.get("/summary")
async def summary(_person: Anyone, chairs: ChairsPart, arming: ArmingPart) -> Summary:
    """Return what arming the chosen chair would apply, and the reasons against it.

    Differences to the last practised set by `kind`: `field`, `binding` or `gesture`; null: there is none yet.
    """
    now = await arming.summary()
    chair, parameters, last = chairs.chosen, now.parameters, now.last_practised
    return Summary(
        chair=None if chair is None else ChairSummary.of(chair),
        parameters=None if parameters is None else ParametersSummary.of(parameters),
        speeds=now.speeds,
        hash=now.hash,
        document=now.document,
        crawls=now.crawls,
        practised=PracticeView.of(now.practice),
        last_practised=None if last is None else LatestPractice.of(last),
        differences=now.differences,
        refusals=now.refusals,
    )


@router.post("", status_code=201)
async def arm(
    body: NewDrive,
    request: Request,
    person: ClinicianInSession,
    *,
    database: Db,
    drive_flow: DriveFlowPart,
    chairs: ChairsPart,
    arming: ArmingPart,
    session_flow: SessionFlowPart,
    screens: ScreensPart,
) -> DriveView:
    """Arm the real chair with the set of the summary; the drive is recorded, and this screen must stay in view.

    409 with the first of `refusals`, for a silent screen, or another `hash` than the summary's; 403 from outside the
    building's network.
    """
    require_nearby(request)
    async with session_flow.undisturbed():
        now = await arming.summary()
        if now.refusals:
            raise Conflict(now.refusals[0])
        chair = chairs.chosen
        if chair is None or now.session is None or now.parameters is None or now.parameters_id is None:
            raise HTTPException(409, CHANGED)  # unreachable: each of these is among the refusals
        if now.hash != body.hash:
            raise Conflict(CHANGED)
        age = screens.age(Screen(person.person_id, body.screen), monotonic())
        if age is None or age > HEARD_WITHIN:
            raise Conflict(NOT_IN_VIEW)
        obstacle = await session_flow.load_parameters()
        if obstacle is not None:
            raise Conflict(obstacle)
        starter = Starter(person.person_id, person.name, body.screen)
        drive_id = await drive_flow.start(now.session, starter, chair, now.parameters_id, body.hash, now.document)
    return await asyncio.to_thread(_one, database, drive_id)


@router.post("/current/end")
async def end_drive(
    person: ClinicianInSession, authority: Authority, database: Db, drive_flow: DriveFlowPart
) -> DriveView:
    """End the drive; answer when its recording is closed."""
    authority.require_controller(person)
    drive_id = await drive_flow.end()
    return await asyncio.to_thread(_one, database, drive_id)


@router.get("")
def list_drives(patient: Annotated[int, Query(ge=1, le=2**31)], person: Anyone, database: Db) -> list[DriveView]:
    """List a patient's drives, the newest last.

    `end`: `by hand` or `fault`; `distance` null: it never moved.
    """
    with database.transaction(closing=True) as db:
        find_patient(db, patient)
        log_viewing(db, person.name, patient)
        return [DriveView.of(drive) for drive in drives_of(db, patient)]


def _one(database: Database, drive_id: int) -> DriveView:
    with database.reading() as db:
        return DriveView.of(find_drive(db, drive_id))
