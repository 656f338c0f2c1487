"""Stop, for anyone, and Continue."""

import asyncio

from fastapi import APIRouter

from app.api.deps import Clinician
from app.api.flows import FlowParts
from app.faults import Fault, State
from app.quantities import Document
from app.session.control import Control
from app.session.refusals import Unavailable

NEXT_TICK_LOOKS = 30  # of 10 ms each: what was cleared shows in one of the next ticks

router = APIRouter(prefix="/control", tags=["stop"])


class ControlView(Document):
    """Whether motion is permitted, and why not."""

    state: str
    fault: str | None


def _view(control: Control) -> ControlView:
    tick = control.newest()
    if tick is None:
        return ControlView(state="fault", fault=Fault.CONTROL_LOST.name.lower())
    fault = Fault(int(tick["fault"]))
    return ControlView(
        state=State(int(tick["state"])).name.lower(), fault=None if fault is Fault.NONE else fault.name.lower()
    )


@router.post("/stop")
async def stop(flows: FlowParts) -> ControlView:
    """Stop the chair: latched, beats every motion, for anyone, signed in or not."""
    try:
        await flows.control.call("stop", by="tablet")
    except Unavailable:
        return ControlView(state="fault", fault=Fault.CONTROL_LOST.name.lower())  # nothing is left that could move
    return ControlView(state="fault", fault=Fault.STOP_TABLET.name.lower())


@router.post("/clear")
async def clear(_who: Clinician, flows: FlowParts) -> ControlView:
    """Clear a latched stop or fault; in a trial a new neutral check follows."""
    before = flows.control.newest()
    await flows.control.call("clear")
    for _ in range(NEXT_TICK_LOOKS):
        now = flows.control.newest()
        if before is None or now is None or int(now["number"]) > int(before["number"]) + 1:
            break
        await asyncio.sleep(0.01)
    return _view(flows.control)
