"""Makes, starts and ends the parts of the web process."""

import asyncio
from collections.abc import Awaitable, Callable

from app.api.computer.graphics import Graphics
from app.api.computer.measurement import Measurement
from app.api.live.hub import LiveHub
from app.api.live.live_picture import LivePicture
from app.api.live.message import LiveMessage
from app.api.live.screen_pictures import ScreenPictures
from app.api.live.screens import Screens
from app.api.parts import WebParts, open_view
from app.api.patient_screen.patient_picture import PatientPicture
from app.api.replay.replays import Replays
from app.api.replay.timelines import Timelines
from app.api.replay.trajectories import Trajectories
from app.api.view.view_keeper import OpenScene, ViewKeeper
from app.computing_process import ComputingProcess
from app.features.registration import features
from app.session.adaptation import AdaptationFlow
from app.session.calibration.calibration_flow import CalibrationFlow
from app.session.calibration.garment import NobodyElse, OthersPrior
from app.session.calibration.gesture_discovery import GestureDiscoveries
from app.session.clinic_spread import ClinicSpread
from app.session.control_link import ControlLink, LinkedProcess
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
from app.session.runs import SessionRuns
from app.session.screen_codes import PairingCodes
from app.session.trial import TrialFlow
from app.session.trial_qualities import TrialQualities
from app.settings import Settings
from app.store.calibrations import fail_interrupted_steps
from app.store.database import Database
from app.store.drives import close_interrupted_drives
from app.store.files.disk_watch import DiskWatch
from app.store.interface_tests import close_interrupted_tests
from app.store.keeping.erasure_watch import ErasureWatch
from app.store.patients import open_session
from app.store.people import the_clinic
from app.store.runs import close_interrupted_trials

StartProcess = Callable[[], Awaitable[LinkedProcess]]


def make_parts(
    settings: Settings,
    database: Database,
    start_process: StartProcess,
    computing: ComputingProcess,
    open_scene: OpenScene | None,
) -> WebParts:
    """Make the parts of the web process; nothing runs before `start_parts`."""
    hub: LiveHub[LiveMessage]

    def tell(event: str) -> None:
        hub.tell(event)

    control = ControlLink(start_process)
    equipment = Equipment(database, control, settings.files, settings.keys, tell, demonstration=settings.demo)
    runs = SessionRuns(database, control, settings.runs, lambda: equipment.simulated)
    chairs = Chairs(database, control, settings.keys, tell)
    limits = ClinicLimits(database, control, tell)
    priors = (one.prior(database) for one in features().values() if one.prior is not None)
    prior: OthersPrior = next(priors, NobodyElse())
    calibration = CalibrationFlow(database, control, equipment, runs, tell, computing, prior)
    trials = TrialFlow(database, control, runs, tell, computing)
    drives = RealDriveFlow(database, control, runs, tell, computing)
    flows = (one.flow for one in features().values() if one.flow is not None)
    others = [make(database, control, runs, tell, computing) for make in flows]
    session = SessionFlow(database, control, equipment, calibration, trials, drives, others, tell)
    live_picture = LivePicture(control, equipment, chairs, runs, trials, drives, others, session)
    hub = LiveHub(live_picture.picture, live_picture.quality, LiveMessage.without_patient)
    patient = PatientPicture(live_picture, equipment, runs, trials)
    patient_hub = LiveHub(patient.picture)

    def current_drive() -> dict[str, int]:
        trial, drive = trials.current, drives.current
        if drive is not None:
            return {"drive": drive.id}
        return {} if trial is None else {"trial": trial.id}

    async def control_changed(_state: str) -> None:
        tell("equipment")

    control.on_change.append(control_changed)
    spread = ClinicSpread(database, computing)
    made = (one.background for one in features().values() if one.background is not None)
    background = [make(database, settings, tell) for make in made]
    web = WebParts(
        computing=computing,
        control=control,
        equipment=equipment,
        shirt_watch=ShirtWatch(equipment),
        runs=runs,
        calibration=calibration,
        discoveries=GestureDiscoveries(database, runs.folder_of, computing),
        trials=trials,
        drives=drives,
        others=others,
        chairs=chairs,
        head=HeadChoice(database, control, equipment.with_path, tell),
        limits=limits,
        arming=RealArming(database, control, equipment, session, chairs, limits),
        session=session,
        adaptation=AdaptationFlow(database, control, runs, trials, session, chairs, tell, computing),
        screens=Screens(),
        pictures=ScreenPictures(control, trials),
        faults=FaultLog(database, control, current_drive),
        disk=DiskWatch(settings.state, database.ballast, tell),
        live=hub,
        pairing=PairingCodes(),
        patient=patient,
        patient_live=patient_hub,
        graphics=Graphics(hub, patient_hub),
        measurement=Measurement(settings.state, lambda: session.recording),
        erasures=ErasureWatch(database, settings),
        trajectories=Trajectories(computing),
        timelines=Timelines(computing),
        qualities=TrialQualities(database, runs.folder_of, computing),
        renewal=MeasuresRenewal(database, runs, computing, tell),
        spread=spread,
        replays=Replays(),
        view=ViewKeeper(open_scene, control.newest),
        own_floorplans=settings.floorplans,
        background=background,
        of_features={type(part): part for part in (*others, *background)},
    )

    control.follow_screen(web.driving_sign)
    return web


async def start_parts(database: Database, web: WebParts) -> None:
    """Start the control process and what watches it; open a 3D view when a session is open."""
    await asyncio.to_thread(_close_interrupted, database, web.runs)
    await web.control.start()
    await web.limits.open()
    await web.chairs.open()
    await web.equipment.open()
    await web.head.open()
    await web.session.session_changed()
    web.shirt_watch.start()
    web.live.start()
    web.patient_live.start()
    web.faults.start()
    web.disk.start()
    web.erasures.start()
    for part in web.background:
        part.start()
    web.renewal.start()
    if await asyncio.to_thread(_is_session_open, database):
        await open_view(web)


def _is_session_open(database: Database) -> bool:
    with database.transaction() as db:
        clinic = the_clinic(db)
        return clinic is not None and open_session(db, clinic.id) is not None


def _close_interrupted(database: Database, runs: SessionRuns) -> None:
    """Mark the runs, steps, trials, drives and tests that an ended web process left running as interrupted."""
    runs.close_interrupted()
    with database.transaction(closing=True) as db:
        fail_interrupted_steps(db)
        close_interrupted_trials(db)
        close_interrupted_drives(db)
        close_interrupted_tests(db)


async def end_parts(web: WebParts) -> None:
    """End what runs, the control process last."""
    await web.calibration.stop()
    await asyncio.gather(web.trials.stop(), web.drives.stop(), *(flow.stop() for flow in web.others))
    await web.adaptation.stop()
    await asyncio.gather(
        web.shirt_watch.close(),
        web.renewal.close(),
        web.live.close(),
        web.patient_live.close(),
        web.faults.close(),
        web.disk.close(),
        web.erasures.close(),
        *(part.close() for part in web.background),
    )
    await asyncio.gather(web.view.close(), web.control.close(), asyncio.to_thread(web.replays.close_all))
    await asyncio.to_thread(web.computing.close)
