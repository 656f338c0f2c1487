"""The replay of a trial in 3D: opened, moved to a moment, shown in a frame, closed. Refused while somebody drives.

Decision 37 says what was measured: the web process, which shows a drive its picture, builds a whole place for it.
"""

from typing import Annotated

from fastapi import APIRouter, Path, Request, Response, WebSocket
from pydantic import Field

from app.api.deps import (
    Anyone,
    ComputingPart,
    Db,
    DriveFlowPart,
    ReplaysPart,
    RunsPart,
    SettingsPart,
    SocketsPart,
    TrialFlowPart,
)
from app.api.page_session import LOOKS, any_session
from app.api.replay.trial_replay import require_ended
from app.api.view.view_bridge import NO_VIEW, ViewPage, bridge
from app.computing_process import ComputingProcess
from app.quantities import Count, Document
from app.refusals import Conflict, NotFound
from app.scene.cameras import View
from app.scene.client_messages import SUBPROTOCOL
from app.scene.replay import Replay, ReplayPoses
from app.scene.viewer_page import client_page
from app.scoring.timeline import recorded_poses
from app.session.real_drive import RealDriveFlow
from app.session.runs import SessionRuns
from app.session.trial import TrialFlow
from app.settings import Settings
from app.store.log import write_log
from app.store.runs import find_trial
from app.store.tables import Trial
from app.texts import Text

MARK = "Replay"
BUSY = Text("api-replay-while-driving")
MOMENTS_PER_SECOND = 20.0

Word = Annotated[str, Path(pattern=r"^[A-Za-z0-9_-]{8,64}$")]
Moment = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-86_400, le=86_400)]  # s

router = APIRouter(tags=["review"])
page_router = APIRouter()


class NewReplay(Document):
    """Which trial to show."""

    trial: Count


class ReplayView(Document):
    """An open replay."""

    id: str


class ReplayMoment(Document):
    """The moment to show, and the view."""

    t: Moment
    view: View = "chase"


@router.post("/replays", status_code=201)
@any_session(LOOKS)
def open_replay(
    body: NewReplay,
    person: Anyone,
    *,
    settings: SettingsPart,
    database: Db,
    computing: ComputingPart,
    runs: RunsPart,
    trial_flow: TrialFlowPart,
    drive_flow: DriveFlowPart,
    replays: ReplaysPart,
) -> ReplayView:
    """Open a trial in 3D, on a server of its own that shows nothing live.

    For this person; there are two on the machine, and the one not looked at for longest gives way. 409 while anybody
    drives.
    """
    refuse_while_driving(trial_flow, drive_flow)
    with database.reading() as db:
        trial = find_trial(db, body.trial)
    require_ended(trial)
    word = replays.add(person.person_id, lambda: _replay_of(settings, computing, runs, trial))
    with database.transaction(closing=True) as db:  # nothing is shown yet: the word has not been answered
        write_log(db, person.name, "trial viewed", trial=trial.id)
    return ReplayView(id=word)


@router.post("/replays/{word}/at", status_code=204)
@any_session(LOOKS)
def show_moment(
    word: Word,
    body: ReplayMoment,
    person: Anyone,
    trial_flow: TrialFlowPart,
    drive_flow: DriveFlowPart,
    replays: ReplaysPart,
) -> None:
    """Show another moment, or look from somewhere else.

    404 when it is closed, 409 while anybody drives.
    """
    refuse_while_driving(trial_flow, drive_flow)
    replays.find(word, person.person_id).show(body.t, body.view)


@router.delete("/replays/{word}", status_code=204)
@any_session(LOOKS)
def close_replay(word: Word, person: Anyone, replays: ReplaysPart) -> None:
    """Close a replay; do nothing when it is closed already."""
    replays.close(word, person.person_id)


def refuse_while_driving(trial_flow: TrialFlow, drive_flow: RealDriveFlow) -> None:
    """Refuse while a chair may move: building the place could delay the live picture."""
    if trial_flow.running or drive_flow.running:
        raise Conflict(BUSY)


def _replay_of(settings: Settings, computing: ComputingProcess, runs: SessionRuns, trial: Trial) -> Replay:
    try:
        plan, poses = computing.ask(recorded_poses, runs.folder_of(trial.run_id), MOMENTS_PER_SECOND)
        return Replay(plan, trial.path, ReplayPoses(*poses), settings.models)
    except (ValueError, OSError) as error:
        raise NotFound(Text("api-no-replay")) from error


page = ViewPage(client_page(MARK))


@page_router.get("/view/replay/{word}/", include_in_schema=False)
def replay_page(word: Word, person: Anyone, replays: ReplaysPart, request: Request) -> Response:
    """Return the page that shows a replay."""
    replays.find(word, person.person_id)
    return page.answer(request)


@page_router.websocket("/view/replay/{word}")
@page_router.websocket("/view/replay/{word}/")
async def replay_socket(websocket: WebSocket, word: str, sockets: SocketsPart, replays: ReplaysPart) -> None:
    """Connect the page of a replay with its server, for the person who opened it."""
    person = await sockets.admit(websocket)
    if person is None:
        return
    if person.locked:
        await websocket.close(NO_VIEW)
        return
    try:
        port = replays.find(word, person.person_id).port
    except NotFound:
        await websocket.close(NO_VIEW)
        return
    if SUBPROTOCOL not in websocket.scope.get("subprotocols", []):
        await websocket.close(NO_VIEW)
        return
    async with sockets.guarded(websocket, person, lambda now: now.sees(None)):
        await bridge(websocket, "patient", port)  # as on the patient's screen: the browser may only tell its camera
