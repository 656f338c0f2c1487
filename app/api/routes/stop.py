"""Stop, for anyone; Continue and the speed dial, for the person who drives."""

import asyncio
from typing import Annotated

from fastapi import APIRouter, BackgroundTasks
from fastapi.requests import Request
from pydantic import Field

from app.api.deps import (
    Clinician,
    ControlPart,
    Db,
    FaultLogPart,
    ForEveryone,
)
from app.api.one_controller import Authority
from app.api.page_session import ClinicianInSession, ShownSession, any_session, require_open
from app.api.sign_in.cookies import read_cookie
from app.api.sign_in.identity import COOKIE, find_sign_in
from app.faults import Fault, State
from app.quantities import Count, Document
from app.session.control_link import ControlLink
from app.session.fault_log import FaultLog
from app.store.database import Database
from app.store.log import write_log

NEXT_TICK_LOOKS = 30  # of 10 ms each, to wait for a tick after the clearing

router = APIRouter(prefix="/control", tags=["stop"])


class ControlView(Document):
    """The state of the gate, and the fault that forbids motion."""

    state: str
    fault: str | None


class StopCount(Document):
    """The number of stops that the person had seen when they tapped Continue."""

    stops: Count


class DialShare(Document):
    """The speed dial: the share of the set speeds."""

    share: Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0.1, le=1.0)]


def _view(control: ControlLink) -> ControlView:
    tick = control.newest()
    if tick is None:
        return ControlView(state="fault", fault=Fault.CONTROL_LOST.name.lower())
    fault = Fault(int(tick["fault"]))
    return ControlView(
        state=State(int(tick["state"])).name.lower(), fault=None if fault is Fault.NONE else fault.name.lower()
    )


@router.post("/stop", dependencies=[ForEveryone])
@any_session("Stop works at any time, for anybody.")
async def stop(
    request: Request, afterwards: BackgroundTasks, database: Db, control: ControlPart, fault_log: FaultLogPart
) -> ControlView:
    """Stop the chair: latched, overrides every motion; for anyone, signed in or not. `by=key`: by the keyboard.

    Who asked is found and logged after the answer: a stop waits for no database.
    """
    afterwards.add_task(_note_who, request, database, fault_log)
    is_key = request.query_params.get("by") == "key"  # whatever else the address says, the chair is stopped
    if await control.stop("key" if is_key else "tablet"):
        return ControlView(state="fault", fault=(Fault.STOP_KEY if is_key else Fault.STOP_TABLET).name.lower())
    return ControlView(state="fault", fault=Fault.CONTROL_LOST.name.lower())  # it has ended, or is being replaced


async def _note_who(request: Request, database: Database, fault_log: FaultLog) -> None:
    if read_cookie(request, COOKIE):
        person = await asyncio.to_thread(find_sign_in, database, request)
        if person is not None:
            await fault_log.stop_requested(person.name)


@router.post("/clear")
async def clear(
    body: StopCount,
    request: Request,
    person: ClinicianInSession,
    authority: Authority,
    control: ControlPart,
) -> ControlView:
    """Clear the latched stop or fault that the person has seen; in a trial or drive a new neutral check follows.

    Without the control process `fault` is `control_lost`, and that process is replaced.
    """
    authority.require_hand_on_chair(person, request)
    authority.require_picture()
    before = control.newest()
    await control.call("clear", stops=body.stops)
    for _ in range(NEXT_TICK_LOOKS):
        now = control.newest()
        if before is None or now is None or int(now["number"]) > int(before["number"]) + 1:
            break
        await asyncio.sleep(0.01)
    return _view(control)


@router.post("/dial")
@any_session("Turning down works at any time; turning up is checked by the route itself.")
async def turn_dial(
    body: DialShare,
    request: Request,
    person: Clinician,
    authority: Authority,
    database: Db,
    control: ControlPart,
    shown: ShownSession = "",
) -> DialShare:
    """Turn the speed dial: down at once, up only while the chair stands and the patient is at rest."""
    authority.require_hand_on_chair(person, request)
    tick = control.newest()
    if tick is not None and body.share > float(tick["dial"]):
        await require_open(database, shown)
    answer = await control.load("dial", share=body.share)
    share = float(answer.get("share", body.share))
    await asyncio.to_thread(_note, database, person.name, share)
    return DialShare(share=share)


def _note(database: Database, person: str, share: float) -> None:
    with database.transaction(closing=True) as db:
        write_log(db, person, "dial turned", share=share)
