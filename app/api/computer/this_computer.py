"""The owner's page "This computer": whether this machine and the screens that are open will do."""

import asyncio
from typing import Annotated

from fastapi import APIRouter
from pydantic import Field

from app.api.computer.measurement import FindingView, MachineView
from app.api.deps import GraphicsPart, MeasurementPart, Owner, SettingsPart
from app.api.page_session import OF_CLINIC, any_session
from app.host.machine_check import screen_finding
from app.quantities import Document
from app.settings import Settings

router = APIRouter(prefix="/computer", tags=["this computer"])


class MeasurementRequest(Document):
    """How long to measure the loop."""

    seconds: Annotated[int, Field(strict=True, ge=1, le=60)]


class ComputerView(Document):
    """What was found of this computer, and of each screen that is open."""

    machine: MachineView
    screens: list[FindingView]


@router.post("/measurement")
@any_session(OF_CLINIC)
async def measure(
    body: MeasurementRequest,
    _person: Owner,
    settings: SettingsPart,
    graphics: GraphicsPart,
    measurement: MeasurementPart,
) -> ComputerView:
    """Measure this computer; answered afterwards. Refused while a chair is armed or something is recorded.

    For owners: measures for `seconds`, and asks open pages for their pictures a second. 409 also when a chair is armed
    or a recording begins meanwhile, and beside another measurement; 503 when it could not measure.
    """
    measurement.refuse_while_busy()
    asking = asyncio.create_task(graphics.ask())
    try:
        machine = await measurement.measure(body.seconds, _own_ports(settings))
        answers = await asking
    finally:
        asking.cancel()
    screens = [FindingView.of(screen_finding(str(name), rate)) for name, rate in answers]
    return ComputerView(machine=machine, screens=screens)


def _own_ports(settings: Settings) -> list[int]:
    network = settings.network
    return [settings.port] if network is None else [settings.port, network.https_port]
