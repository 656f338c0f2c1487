"""The long-lived parts behind the routes: control, equipment, calibration, trials, the live picture."""

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from fastapi import Depends
from starlette.requests import HTTPConnection

from app.api.live_hub import LiveHub
from app.api.trajectories import Trajectories
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
    own_floorplans: Path

    def floorplan_files(self) -> dict[str, Path]:
        """Return the files of all floor plans by name: the bundled ones, then the clinic's own."""
        own = {file.stem: file for file in sorted(self.own_floorplans.glob("*.json"))}
        return {**own, **bundled_floorplans()}


def load_plan(flows: Flows, name: str) -> FloorPlan | None:
    """Return a floor plan by its name, None when there is none."""
    file = flows.floorplan_files().get(name)
    return None if file is None else load_floorplan(file)


def flows(connection: HTTPConnection) -> Flows:
    """Return the long-lived parts."""
    found: Flows = connection.app.state.flows
    return found


FlowParts = Annotated[Flows, Depends(flows)]
