"""The live websocket of the patient's screen: it shows, and listens to nothing."""

import asyncio

from fastapi import APIRouter, WebSocket
from fastapi.concurrency import run_in_threadpool

from app.api.deps import People
from app.api.flows import Flows
from app.api.live_hub import Viewer
from app.clock import monotonic
from app.session.store_patient_screens import wishes_of

router = APIRouter()

FLOOD = 20  # messages within ...
WITHIN = 10.0  # s; our page sends none at all
NOT_HEARD = 1008  # close code: a page that talks is none of ours


@router.websocket("/patient/live")
async def patient_live(websocket: WebSocket) -> None:
    """Show the newest moment 20 times a second."""
    parts: People = websocket.app.state.people
    flows: Flows = websocket.app.state.flows
    who = await parts.sockets.admit_screen(websocket)
    if who is None:
        return
    visit_id = who.visit_id

    def _read() -> None:
        with parts.database.transaction() as db:
            flows.patient.wishes = wishes_of(db, visit_id)

    await run_in_threadpool(_read)
    await websocket.accept()
    viewer = Viewer(websocket)
    async with parts.sockets.guarded(websocket, who):
        flows.live.tell("screens")
        sending = asyncio.create_task(flows.patient_live.serve(viewer))
        try:
            await _ignore(websocket)
        except RuntimeError:
            pass  # closed by us
        finally:
            flows.patient_live.forget(viewer)
            sending.cancel()
            await asyncio.gather(sending, return_exceptions=True)
    flows.live.tell("screens")


async def _ignore(websocket: WebSocket) -> None:
    """Take what a page sends without looking at it, until it goes or sends more than a slip can explain."""
    count, since = 0, monotonic()
    while (await websocket.receive())["type"] != "websocket.disconnect":
        if monotonic() - since > WITHIN:
            count, since = 0, monotonic()
        count += 1
        if count > FLOOD:
            await websocket.close(NOT_HEARD)
            return
