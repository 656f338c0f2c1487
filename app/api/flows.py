"""The long-lived parts behind the routes: control, equipment, calibration, trials, the live picture."""

import asyncio
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from fastapi import Depends, FastAPI
from starlette.requests import HTTPConnection

from app.api.live_hub import LiveHub
from app.api.trajectories import Trajectories
from app.api.view_keeper import ViewKeeper
from app.session.calibration_flow import CalibrationFlow
from app.session.control import Control
from app.session.drive_flow import DriveFlow
from app.session.equipment import Equipment
from app.session.runs import Runs
from app.session.visit_flow import VisitFlow
from app.world.floorplan import FloorPlan, bundled_floorplans, load_floorplan


@dataclass(slots=True)
class Flows:
    """What goes on, whether or not anybody looks."""

    control: Control
    equipment: Equipment
    runs: Runs
    calibration: CalibrationFlow
    drive: DriveFlow
    visit: VisitFlow
    live: LiveHub
    trajectories: Trajectories
    view: ViewKeeper
    own_floorplans: Path

    def floorplan_files(self) -> dict[str, Path]:
        """Return the files of all floor plans by name: the bundled ones, then the clinic's own."""
        own = {file.stem: file for file in sorted(self.own_floorplans.glob("*.json"))}
        return {**own, **bundled_floorplans()}


def load_plan(flows: Flows, name: str) -> FloorPlan | None:
    """Return a floor plan by its name, None when there is none."""
    file = flows.floorplan_files().get(name)
    return None if file is None else load_floorplan(file)


def plan_to_begin_with(flows: Flows) -> tuple[FloorPlan, str] | None:
    """Return the first floor plan that can be read and its first path, for a view that has to show something."""
    for name in bundled_floorplans():
        with suppress(ValueError):
            plan = load_plan(flows, name)
            if plan is not None:
                return plan, plan.paths[0].name
    return None


async def show_visit(flows: Flows) -> None:
    """Open a 3D view for the visit that began."""
    first = await asyncio.to_thread(plan_to_begin_with, flows)
    await flows.view.open(*(first or (None, None)))


def flows_of(app: FastAPI) -> Flows:
    """Return the long-lived parts of an application that has started."""
    found: Flows = app.state.flows
    return found


def flows(connection: HTTPConnection) -> Flows:
    """Return the long-lived parts."""
    return flows_of(connection.app)


FlowParts = Annotated[Flows, Depends(flows)]
