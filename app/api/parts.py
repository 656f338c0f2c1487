"""The long-lived parts of the web process: control link, equipment, calibration, trials, the live picture."""

import asyncio
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any, TypeVar

from fastapi import Depends, FastAPI
from starlette.requests import HTTPConnection

from app.api.computer.graphics import Graphics
from app.api.computer.measurement import Measurement
from app.api.live.hub import LiveHub
from app.api.live.message import LiveMessage
from app.api.live.screen_pictures import ScreenPictures
from app.api.live.screens import SILENCE_LIMIT, VIRTUAL_SILENCE_LIMIT, PageSign, Screen, Screens
from app.api.patient_screen.patient_picture import PatientMessage, PatientPicture
from app.api.replay.replays import Replays
from app.api.replay.timelines import Timelines
from app.api.replay.trajectories import Trajectories
from app.api.view.view_keeper import ViewKeeper
from app.clock import monotonic
from app.computing_process import ComputingProcess
from app.features.registration import Background
from app.session.adaptation import AdaptationFlow
from app.session.calibration.calibration_flow import CalibrationFlow
from app.session.calibration.gesture_discovery import GestureDiscoveries
from app.session.clinic_spread import ClinicSpread
from app.session.control_link import ControlLink, ScreenSign
from app.session.equipment.chairs import Chairs
from app.session.equipment.head import HeadChoice
from app.session.equipment.limits import ClinicLimits
from app.session.equipment.shirt import Equipment
from app.session.equipment.shirt_watch import ShirtWatch
from app.session.fault_log import FaultLog
from app.session.measures_renewal import MeasuresRenewal
from app.session.open_session import SessionFlow
from app.session.real_arming import RealArming
from app.session.real_drive import RealDriveFlow
from app.session.run_flow import RunFlow
from app.session.runs import SessionRuns
from app.session.screen_codes import PairingCodes
from app.session.trial import TrialFlow
from app.session.trial_qualities import TrialQualities
from app.store.files.disk_watch import DiskWatch
from app.store.keeping.erasure_watch import ErasureWatch
from app.world.floorplan import FloorPlan, bundled_floorplans, load_floorplan
from app.world.path_titles import find_floorplan
from app.world.scene import DrivingPlace, bundled_places

Part = TypeVar("Part")


@dataclass(slots=True)
class WebParts:
    """The parts of the web process that live as long as it does, also while no page is open."""

    computing: ComputingProcess
    control: ControlLink
    equipment: Equipment
    shirt_watch: ShirtWatch
    runs: SessionRuns
    calibration: CalibrationFlow
    discoveries: GestureDiscoveries
    trials: TrialFlow
    drives: RealDriveFlow
    others: list[RunFlow[Any]]  # of features: what else is recorded in a session
    chairs: Chairs
    head: HeadChoice
    limits: ClinicLimits
    arming: RealArming
    session: SessionFlow
    adaptation: AdaptationFlow
    screens: Screens
    pictures: ScreenPictures
    faults: FaultLog
    disk: DiskWatch
    erasures: ErasureWatch
    live: LiveHub[LiveMessage]
    pairing: PairingCodes
    patient: PatientPicture
    patient_live: LiveHub[PatientMessage]
    graphics: Graphics
    measurement: Measurement
    trajectories: Trajectories
    timelines: Timelines
    qualities: TrialQualities
    renewal: MeasuresRenewal
    spread: ClinicSpread
    replays: Replays
    view: ViewKeeper
    own_floorplans: Path
    background: list[Background]  # of features
    of_features: dict[type, Any] = field(default_factory=dict)

    def of_feature(self, kind: type[Part], make: Callable[[], Part]) -> Part:
        """Return the part of this kind that a feature has, made when it is asked for first. For any thread.

        Two threads that ask at once may make two: both get the one that was stored.
        """
        if kind not in self.of_features:
            self.of_features.setdefault(kind, make())
        part: Part = self.of_features[kind]
        return part

    def driving_sign(self) -> ScreenSign:
        """Return the last report of the screen that started the trial or drive; may be called from any thread."""
        drive, trial = self.drives.current, self.trials.current  # read once each: they may end meanwhile
        going_on = drive or trial
        if going_on is None:
            return ScreenSign()
        limit = VIRTUAL_SILENCE_LIMIT if drive is None else SILENCE_LIMIT
        screen = Screen(going_on.person_id, going_on.screen)
        sign = self.screens.sign(screen, monotonic(), limit)
        is_late = drive is None and sign.view == "in view" and self.pictures.is_late(screen)
        return ScreenSign(sign.age, "slow") if is_late else sign

    def take_sign(self, screen: Screen, sign: PageSign) -> bool:
        """Store the report of a screen, unless another socket reports for that screen; return whether it was stored.

        When the screen that drives goes out of view, stop the chair by a heartbeat at once.
        """
        before = self.driving_sign()
        is_taken = self.screens.take(screen, sign)
        if before.view == "in view" != self.driving_sign().view:
            self.control.beat()
        return is_taken

    def screen_lost(self, screen: Screen, socket: object) -> None:
        """Remove a screen whose socket has ended; when it is the one that drives, the chair stops."""
        before = self.driving_sign()
        self.screens.remove(screen, socket)
        if before.age is not None and self.driving_sign().age is None:
            self.control.beat()

    def places(self) -> dict[str, DrivingPlace]:
        """Return all places to drive in by name: scenes, buildings, then the clinic's own plans that can be read."""
        own: dict[str, DrivingPlace] = {}
        for file in sorted(self.own_floorplans.glob("*.json")):
            with suppress(ValueError):
                own[file.stem] = DrivingPlace(load_floorplan(file))
        bundled = bundled_places()
        return bundled | {name: offer for name, offer in own.items() if name not in bundled}


def load_plan(web: WebParts, name: str) -> FloorPlan | None:
    """Return a floor plan by its name, None when there is none."""
    return find_floorplan(web.own_floorplans, name)


def plan_to_begin_with(web: WebParts) -> tuple[FloorPlan, str] | None:
    """Return the first readable floor plan and its first path, for the view before the first trial."""
    for name in bundled_floorplans():
        with suppress(ValueError):
            plan = load_plan(web, name)
            if plan is not None:
                return plan, plan.paths[0].name
    return None


async def open_view(web: WebParts) -> None:
    """Open a 3D view for the session that began."""
    first = await asyncio.to_thread(plan_to_begin_with, web)
    await web.view.open(*(first or (None, None)))


def web_parts_of(app: FastAPI) -> WebParts:
    """Return the parts of an application that has started."""
    found: WebParts = app.state.web
    return found


async def web_parts(connection: HTTPConnection) -> WebParts:
    """Return the parts; async, so that FastAPI starts no thread for it: Stop needs them at once."""
    return web_parts_of(connection.app)


Web = Annotated[WebParts, Depends(web_parts)]
