"""Puts the web process together: parts, routes, pages."""

import asyncio
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager

from fastapi import APIRouter, FastAPI

from app import __version__
from app.api import document
from app.api.deps import People, clinician, viewer
from app.api.live import live_socket, screen
from app.api.live.hub import LiveHub
from app.api.live.picture import LivePicture
from app.api.live.pictures import Pictures
from app.api.live.screens import Screens
from app.api.page_session import SessionRequired
from app.api.pages import install_pages
from app.api.parts import Flows, flows_of, show_visit
from app.api.patient_screen import patient_socket
from app.api.patient_screen import routes as patient_screen
from app.api.patient_screen.patient_picture import PatientPicture
from app.api.refusals import install_refusals
from app.api.replay import replay_view, trial_replay
from app.api.replay.replays import Replays
from app.api.replay.timelines import Timelines
from app.api.replay.trajectories import Trajectories
from app.api.routes import (
    adaptation,
    calibration,
    chairs,
    control,
    control_quality,
    controls,
    drives,
    equipment,
    limits,
    log,
    models,
    patients,
    plans,
    replacements,
    review,
    shown_plan,
    trials,
)
from app.api.sign_in import auth
from app.api.sign_in.hashing import Hashing
from app.api.sign_in.set_up import SetUp
from app.api.sign_in.sign_in_limits import SignInLimits
from app.api.sockets import OpenSockets
from app.api.view.view_bridge import view_router
from app.api.view.view_controls import view_controls
from app.api.view.view_keeper import OpenScene, ViewKeeper, may_view
from app.scene.servers import Role
from app.scene.session_scene import Scene
from app.session.adaptation import AdaptationFlow
from app.session.arming import RealArming
from app.session.calibration import CalibrationFlow
from app.session.control_link import ControlLink, LinkedProcess
from app.session.equipment.chairs import Chairs
from app.session.equipment.head import HeadChoice
from app.session.equipment.limits import ClinicLimits
from app.session.equipment.shirt import Equipment
from app.session.fault_log import FaultLog
from app.session.open_session import VisitFlow
from app.session.readings import Readings
from app.session.real_drive import RealDriveFlow
from app.session.runs import Runs
from app.session.screen_codes import PairingCodes
from app.session.trial import DriveFlow
from app.session.trial_qualities import TrialQualities
from app.settings import Settings
from app.store.calibrations import fail_interrupted_steps
from app.store.database import Database
from app.store.drives import close_interrupted_drives
from app.store.files.disk import DiskWatch
from app.store.files.replacements import replaced_files
from app.store.log_chain import warn_of_changed_log
from app.store.patients import open_session
from app.store.people import the_clinic
from app.store.runs import close_interrupted_trials

PREFIX = "/api/v1"
ROUTES = (
    auth,
    patients,
    equipment,
    chairs,
    limits,
    calibration,
    controls,
    adaptation,
    trials,
    trial_replay,
    replay_view,
    plans,
    models,
    replacements,
    drives,
    review,
    control_quality,
    log,
    control,
    live_socket,
    screen,
    patient_screen,
    patient_socket,
    document,
    shown_plan,
)

WebApp = FastAPI
StartProcess = Callable[[], Awaitable[LinkedProcess]]


def create_app(
    settings: Settings, start_process: StartProcess, readings: Readings, open_scene: OpenScene | None = None
) -> FastAPI:
    """Return the web application; its parts start and end with it.

    `start_process` starts a control process, `readings` reads recordings, and `open_scene` opens the 3D view of a
    session; without `open_scene` there is no 3D view.
    """

    @asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[None]:
        database = await asyncio.to_thread(Database, settings.database)
        people = People(
            settings=settings,
            database=database,
            hashing=Hashing(),
            limits=SignInLimits(),
            set_up=SetUp(settings.setup_code),
            sockets=OpenSockets(settings, database),
            replaced=replaced_files(settings),
        )
        flows = _flows(settings, database, start_process, readings, open_scene)
        app.state.people, app.state.flows = people, flows
        await _start(database, flows)
        checking = asyncio.create_task(asyncio.to_thread(warn_of_changed_log, settings.database))
        try:
            yield
        finally:
            await asyncio.gather(checking, return_exceptions=True)
            await people.sockets.close_all()
            await people.hashing.close()
            await _end(flows)
            database.close()

    app = FastAPI(
        title="bodydrive",
        version=__version__,
        lifespan=lifespan,
        openapi_url=None,  # document.py serves it, to owners; FastAPI's pages for it load foreign scripts
    )

    def scene_now() -> Scene | None:
        return flows_of(app).view.scene

    def port_of(role: Role) -> int | None:
        return flows_of(app).view.port(role)

    install_refusals(app)
    api = APIRouter(prefix=PREFIX, dependencies=[SessionRequired])
    for module in ROUTES:
        api.include_router(module.router)
    api.include_router(view_controls(scene_now, clinician))
    app.include_router(api)
    app.include_router(replay_view.page_router)
    app.include_router(view_router(port_of, may_view, viewer))
    install_pages(app, settings)
    return app


async def say_goodbye(app: WebApp) -> None:
    """Close every open page's sockets, so that nothing is waited for when the program ends."""
    found: People | None = getattr(app.state, "people", None)
    if found is not None:
        await found.sockets.close_all()


def _flows(
    settings: Settings,
    database: Database,
    start_process: StartProcess,
    readings: Readings,
    open_scene: OpenScene | None,
) -> Flows:
    hub: LiveHub

    def tell(event: str) -> None:
        hub.tell(event)

    control = ControlLink(start_process)
    runs = Runs(database, control, settings.runs)
    worn = Equipment(database, control, settings.files, settings.keys, tell, demonstration=settings.demo)
    seats = Chairs(database, control, settings.keys, tell)
    allowed = ClinicLimits(database, control, tell)
    wizard = CalibrationFlow(database, control, worn, runs, tell, readings)
    drive = DriveFlow(database, control, runs, tell, readings)
    real = RealDriveFlow(database, control, runs, tell, readings)
    visit = VisitFlow(database, control, worn, wizard, drive, real, tell)
    shown = LivePicture(control, worn, seats, runs, drive, real, visit)
    hub = LiveHub(shown.picture, shown.quality)
    patient = PatientPicture(shown, worn, runs, drive)

    def driven_now() -> dict[str, int]:
        trial, drive_now = drive.trial, real.drive
        if drive_now is not None:
            return {"drive": drive_now.id}
        return {} if trial is None else {"trial": trial.id}

    async def control_changed(_state: str) -> None:
        tell("equipment")

    control.on_change.append(control_changed)
    flows = Flows(
        control=control,
        equipment=worn,
        runs=runs,
        calibration=wizard,
        drive=drive,
        real=real,
        chairs=seats,
        head=HeadChoice(database, control, worn.located, tell),
        limits=allowed,
        arming=RealArming(database, control, worn, visit, seats, allowed),
        visit=visit,
        adaptation=AdaptationFlow(database, control, runs, drive, visit, seats, tell, readings),
        screens=Screens(),
        pictures=Pictures(control, drive),
        faults=FaultLog(database, control, driven_now),
        disk=DiskWatch(settings.state, database.ballast, tell),
        live=hub,
        pairing=PairingCodes(),
        patient=patient,
        patient_live=LiveHub(patient.picture, dict),
        trajectories=Trajectories(readings.drive),
        timelines=Timelines(),
        qualities=TrialQualities(database, runs.folder_of, readings.quality),
        replays=Replays(),
        view=ViewKeeper(open_scene, control.newest),
        own_floorplans=settings.floorplans,
    )

    control.screen_sign = flows.driving_sign
    return flows


async def _start(database: Database, flows: Flows) -> None:
    await asyncio.to_thread(_tidy_up, database)
    await flows.control.start()
    await flows.limits.open()
    await flows.chairs.open()
    await flows.equipment.open()
    await flows.head.open()
    await flows.visit.visit_changed()
    flows.live.start()
    flows.patient_live.start()
    flows.faults.start()
    flows.disk.start()
    if await asyncio.to_thread(_somebody_is_here, database):
        await show_visit(flows)


def _somebody_is_here(database: Database) -> bool:
    with database.transaction() as db:
        clinic = the_clinic(db)
        return clinic is not None and open_session(db, clinic.id) is not None


def _tidy_up(database: Database) -> None:
    """Say of what a dead web process left running that it was interrupted."""
    with database.transaction(closing=True) as db:
        fail_interrupted_steps(db)
        close_interrupted_trials(db)
        close_interrupted_drives(db)


async def _end(flows: Flows) -> None:
    await flows.calibration.stop()
    await asyncio.gather(flows.drive.stop(), flows.real.stop())
    await flows.adaptation.stop()
    await asyncio.gather(flows.live.close(), flows.patient_live.close(), flows.faults.close(), flows.disk.close())
    await asyncio.gather(flows.view.close(), flows.control.close(), asyncio.to_thread(flows.replays.close_all))
