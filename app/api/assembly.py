"""Makes, starts and ends the parts of the web process."""

import asyncio
from collections.abc import Awaitable, Callable
from typing import Any, NamedTuple

from fastapi import FastAPI

from app.api.computer.graphics import Graphics
from app.api.computer.measurement import Measurement
from app.api.driving.clinic_places import ClinicPlaces
from app.api.foreign_files import Readings, Uploads
from app.api.live.camera_socket import ActiveCamera
from app.api.live.driving_screen import DrivingScreen
from app.api.live.live_picture import ClinicLive, LivePicture
from app.api.live.message import LiveMessage
from app.api.live.phone_socket import ActivePhones
from app.api.live.screen_pictures import ScreenPictures
from app.api.live.screens import Screens
from app.api.package_download import ExportCourses
from app.api.parts import Parts
from app.api.patient_screen.patient_picture import PatientLive, PatientPicture
from app.api.replay.replays import Replays
from app.api.replay.timelines import Timelines
from app.api.replay.trajectories import Trajectories
from app.api.sign_in.hashing import Hashing
from app.api.sign_in.set_up import SetUp
from app.api.sign_in.sign_in_limits import SignInLimits
from app.api.sockets import OpenSockets
from app.api.view.view_keeper import OpenScene, ViewKeeper, open_view
from app.computing_process import ComputingProcess
from app.features.registration import Background, features
from app.news import News, Notify
from app.session.adaptation import AdaptationFlow
from app.session.calibration.calibration_flow import CalibrationFlow
from app.session.calibration.garment import NobodyElse, OthersPrior
from app.session.calibration.gesture_discovery import GestureDiscoveries
from app.session.clinic_spread import ClinicSpread
from app.session.control_link import ControlLink, LinkedProcess
from app.session.equipment.chairs import Chairs
from app.session.equipment.head import HeadChoice
from app.session.equipment.limits import ClinicLimits
from app.session.equipment.paired_phones import PairedPhones
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
from app.settings import Settings
from app.store.calibrations import fail_interrupted_steps
from app.store.database import Database
from app.store.drives import close_interrupted_drives
from app.store.files.disk_watch import DiskWatch
from app.store.files.plans import OwnPlans
from app.store.files.replacements import ReplacedFiles, replaced_files
from app.store.interface_tests import close_interrupted_tests
from app.store.keeping.erasure_watch import ErasureWatch
from app.store.patients import open_session
from app.store.runs import close_interrupted_trials

StartProcess = Callable[[], Awaitable[LinkedProcess]]


class FeatureParts(NamedTuple):
    """What features let run: in a session, and as long as the web process."""

    flows: list[RunFlow[Any]]
    background: list[Background]


def make_parts(
    app: FastAPI,
    settings: Settings,
    database: Database,
    start_process: StartProcess,
    computing: ComputingProcess,
    open_scene: OpenScene | None,
) -> Parts:
    """Make the parts of the web process, and give them to the application; nothing runs before `start_parts`."""
    parts = app.state.parts = Parts()
    parts.add(Settings, settings)
    parts.add(Database, database)
    parts.add(ComputingProcess, computing)
    _add_what_runs(parts, start_process)
    _add_pictures(parts)
    _add_what_is_recorded(parts)
    _add_sign_in(parts)
    parts.add(ReplacedFiles, replaced_files(settings))
    parts.add(OwnPlans, OwnPlans(settings.floorplans))
    parts.add(ClinicPlaces, ClinicPlaces(settings.floorplans))
    parts.add(Readings, Readings())
    parts.add(Uploads, Uploads())
    parts.add(ExportCourses, ExportCourses())
    parts.add(Measurement, Measurement(settings.state, lambda: parts[SessionFlow].recording))
    parts.add(ViewKeeper, ViewKeeper(open_scene, parts[ControlLink].newest))
    for feature in features().values():
        feature.add_parts(parts)
    return parts


def _notifier(parts: Parts) -> Notify:
    """Return what tells the pages that something has changed on the server."""

    def notify(news: News) -> None:
        parts[ClinicLive].notify(news)

    return notify


def _add_what_runs(parts: Parts, start_process: StartProcess) -> None:
    """Add the link to the control process, the equipment, and the flows of a session."""
    settings, database, computing, notify = parts[Settings], parts[Database], parts[ComputingProcess], _notifier(parts)
    control = parts.add(ControlLink, ControlLink(start_process))
    choices = Equipment(database, control, settings.files, settings.keys, notify, demonstration=settings.demo)
    equipment = parts.add(Equipment, choices)
    parts.add(ShirtWatch, ShirtWatch(equipment))
    runs = parts.add(SessionRuns, SessionRuns(database, control, settings.runs, lambda: equipment.simulated))
    chairs = parts.add(Chairs, Chairs(database, control, settings.keys, notify))
    parts.add(HeadChoice, HeadChoice(database, control, equipment.with_path, notify))
    limits = parts.add(ClinicLimits, ClinicLimits(database, control, notify))
    priors = (feature.prior(database) for feature in features().values() if feature.prior is not None)
    prior: OthersPrior = next(priors, NobodyElse())
    flow = CalibrationFlow(database, control, equipment, runs, notify, computing, prior, demonstration=settings.demo)
    calibration = parts.add(CalibrationFlow, flow)
    trials = parts.add(TrialFlow, TrialFlow(database, control, runs, notify, computing))
    drives = parts.add(RealDriveFlow, RealDriveFlow(database, control, runs, notify, computing))
    flows = (feature.flow for feature in features().values() if feature.flow is not None)
    others = [make(database, control, runs, notify, computing) for make in flows]
    makers = (feature.background for feature in features().values() if feature.background is not None)
    background = [make(parts, notify) for make in makers]
    parts.add(FeatureParts, FeatureParts(others, background))
    for part in (*others, *background):
        parts.add(type(part), part)
    session = parts.add(
        SessionFlow, SessionFlow(database, control, equipment, calibration, trials, drives, others, notify)
    )
    parts.add(RealArming, RealArming(database, control, equipment, session, chairs, limits))
    parts.add(AdaptationFlow, AdaptationFlow(database, control, runs, trials, session, chairs, notify, computing))

    async def control_changed(_state: str) -> None:
        notify(News(what="equipment"))

    control.on_change.append(control_changed)


def _add_pictures(parts: Parts) -> None:
    """Add what the pages and the patient's screens are sent, and what they report."""
    control, equipment, runs, trials = parts[ControlLink], parts[Equipment], parts[SessionRuns], parts[TrialFlow]
    drives = parts[RealDriveFlow]
    picture = LivePicture(
        control, equipment, parts[Chairs], runs, trials, drives, parts[FeatureParts].flows, parts[SessionFlow]
    )
    live = parts.add(ClinicLive, ClinicLive(picture.picture, picture.quality, LiveMessage.without_patient))
    patient = parts.add(PatientPicture, PatientPicture(picture, equipment, runs, trials))
    patient_live = parts.add(PatientLive, PatientLive(patient.picture))
    parts.add(Graphics, Graphics(live, patient_live))
    parts.add(ActiveCamera, ActiveCamera())
    parts.add(ActivePhones, ActivePhones())
    screens = parts.add(Screens, Screens())
    pictures = parts.add(ScreenPictures, ScreenPictures(control, trials))
    driving = parts.add(DrivingScreen, DrivingScreen(control, trials, drives, screens, pictures))
    control.follow_screen(driving.sign)


def _add_what_is_recorded(parts: Parts) -> None:
    """Add what reads recordings, and what keeps the state of the clinic."""
    settings, database, computing, notify = parts[Settings], parts[Database], parts[ComputingProcess], _notifier(parts)
    runs, trials, drives = parts[SessionRuns], parts[TrialFlow], parts[RealDriveFlow]

    def current_drive() -> dict[str, int]:
        trial, drive = trials.current, drives.current
        if drive is not None:
            return {"drive": drive.id}
        return {} if trial is None else {"trial": trial.id}

    parts.add(FaultLog, FaultLog(database, parts[ControlLink], current_drive))
    parts.add(DiskWatch, DiskWatch(settings.state, database.ballast, notify))
    parts.add(ErasureWatch, ErasureWatch(database, settings))
    parts.add(GestureDiscoveries, GestureDiscoveries(database, runs.folder_of, computing))
    parts.add(Trajectories, Trajectories(computing))
    parts.add(Timelines, Timelines(computing))
    parts.add(TrialQualities, TrialQualities(database, runs.folder_of, computing))
    parts.add(MeasuresRenewal, MeasuresRenewal(database, runs, computing, notify))
    parts.add(ClinicSpread, ClinicSpread(database, computing))
    parts.add(Replays, Replays())


def _add_sign_in(parts: Parts) -> None:
    """Add what decides who may sign in, and what closes the sockets of those who may no longer."""
    settings, session = parts[Settings], parts[SessionFlow]
    parts.add(Hashing, Hashing())
    parts.add(SignInLimits, SignInLimits())
    parts.add(SetUp, SetUp(settings.setup_code))
    parts.add(PairingCodes, PairingCodes())
    phones = parts.add(PairedPhones, PairedPhones())
    parts.add(OpenSockets, OpenSockets(settings, parts[Database], phones, busy=lambda: session.recording))


def _watching(parts: Parts) -> list[Background]:
    return [
        *(parts[ShirtWatch], parts[ClinicLive], parts[PatientLive], parts[FaultLog]),
        *(parts[DiskWatch], parts[ErasureWatch], parts[MeasuresRenewal]),
        *parts[FeatureParts].background,
    ]


async def start_parts(parts: Parts) -> None:
    """Start the control process and what watches it; open a 3D view when a session is open."""
    await asyncio.to_thread(_close_interrupted, parts[Database], parts[SessionRuns])
    await parts[ControlLink].start()
    await parts[ClinicLimits].open()
    await parts[Chairs].open()
    await parts[Equipment].open()
    await parts[HeadChoice].open()
    await parts[SessionFlow].session_changed()
    for watching in _watching(parts):
        watching.start()
    if await asyncio.to_thread(_is_session_open, parts[Database]):
        await open_view(parts[ViewKeeper], parts[ClinicPlaces])


def _is_session_open(database: Database) -> bool:
    with database.reading() as db:
        return open_session(db) is not None


def _close_interrupted(database: Database, runs: SessionRuns) -> None:
    """Mark the runs, steps, trials, drives and tests that an ended web process left running as interrupted."""
    runs.close_interrupted()
    with database.transaction(closing=True) as db:
        fail_interrupted_steps(db)
        close_interrupted_trials(db)
        close_interrupted_drives(db)
        close_interrupted_tests(db)


async def end_parts(parts: Parts) -> None:
    """Close every open page, then end what runs, the control process and the database last."""
    await parts[OpenSockets].close_all()
    await parts[Hashing].close()
    await parts[CalibrationFlow].stop()
    others = parts[FeatureParts].flows
    await asyncio.gather(parts[TrialFlow].stop(), parts[RealDriveFlow].stop(), *(flow.stop() for flow in others))
    await parts[AdaptationFlow].stop()
    await asyncio.gather(*(watching.close() for watching in _watching(parts)))
    await asyncio.gather(
        parts[ViewKeeper].close(), parts[ControlLink].close(), asyncio.to_thread(parts[Replays].close_all)
    )
    await asyncio.to_thread(parts[ComputingProcess].close)
    parts[Database].close()
