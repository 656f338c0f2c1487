"""Dependencies of the routes: the parts of the web process, and the person who is signed in with the needed right."""

from typing import Annotated

from fastapi import Depends, HTTPException, Path
from starlette.requests import HTTPConnection

from app.api.computer.graphics import Graphics
from app.api.computer.measurement import Measurement
from app.api.driving.clinic_places import ClinicPlaces
from app.api.foreign_files import Readings, Uploads
from app.api.live.driving_screen import DrivingScreen
from app.api.live.live_picture import ClinicLive
from app.api.live.screen_pictures import ScreenPictures
from app.api.live.screens import Screens
from app.api.parts import part
from app.api.patient_screen.patient_picture import PatientLive, PatientPicture
from app.api.replay.replays import Replays
from app.api.replay.timelines import Timelines
from app.api.replay.trajectories import Trajectories
from app.api.sign_in.hashing import Hashing
from app.api.sign_in.identity import PairedScreen, SignedInPerson, find_viewer
from app.api.sign_in.set_up import SetUp
from app.api.sign_in.sign_in_limits import SignInLimits
from app.api.sockets import OpenSockets
from app.api.view.view_keeper import ViewKeeper
from app.api.who_asks import WhoAsks
from app.computing_process import ComputingProcess
from app.scene.role_servers import Role
from app.session.calibration.calibration_flow import CalibrationFlow
from app.session.calibration.gesture_discovery import GestureDiscoveries
from app.session.clinic_spread import ClinicSpread
from app.session.control_link import ControlLink
from app.session.equipment.chairs import Chairs
from app.session.equipment.head import HeadChoice
from app.session.equipment.limits import ClinicLimits
from app.session.equipment.paired_phones import PairedPhones
from app.session.equipment.shirt import Equipment
from app.session.fault_log import FaultLog
from app.session.open_session import SessionFlow
from app.session.real_arming import RealArming
from app.session.real_drive import RealDriveFlow
from app.session.runs import SessionRuns
from app.session.screen_codes import PairingCodes
from app.session.trial import TrialFlow
from app.session.trial_qualities import TrialQualities
from app.settings import Settings
from app.store.access.rights import EXPORTERS
from app.store.database import Database
from app.store.files.plans import OwnPlans
from app.store.files.replacements import ReplacedFiles
from app.texts import Text

RowId = Annotated[int, Path(ge=1, le=2**31)]

LOCKED = Text("api-locked")
NOBODY = Text("api-not-signed-in")

Db = Annotated[Database, Depends(part(Database))]
SettingsPart = Annotated[Settings, Depends(part(Settings))]
HashingPart = Annotated[Hashing, Depends(part(Hashing))]
SignInLimitsPart = Annotated[SignInLimits, Depends(part(SignInLimits))]
SetUpPart = Annotated[SetUp, Depends(part(SetUp))]
SocketsPart = Annotated[OpenSockets, Depends(part(OpenSockets))]
ReplacedFilesPart = Annotated[ReplacedFiles, Depends(part(ReplacedFiles))]
OwnPlansPart = Annotated[OwnPlans, Depends(part(OwnPlans))]
ReadingsPart = Annotated[Readings, Depends(part(Readings))]
UploadsPart = Annotated[Uploads, Depends(part(Uploads))]
ComputingPart = Annotated[ComputingProcess, Depends(part(ComputingProcess))]
ControlPart = Annotated[ControlLink, Depends(part(ControlLink))]
EquipmentPart = Annotated[Equipment, Depends(part(Equipment))]
HeadPart = Annotated[HeadChoice, Depends(part(HeadChoice))]
ChairsPart = Annotated[Chairs, Depends(part(Chairs))]
LimitsPart = Annotated[ClinicLimits, Depends(part(ClinicLimits))]
ArmingPart = Annotated[RealArming, Depends(part(RealArming))]
SessionFlowPart = Annotated[SessionFlow, Depends(part(SessionFlow))]
CalibrationFlowPart = Annotated[CalibrationFlow, Depends(part(CalibrationFlow))]
DiscoveriesPart = Annotated[GestureDiscoveries, Depends(part(GestureDiscoveries))]
TrialFlowPart = Annotated[TrialFlow, Depends(part(TrialFlow))]
DriveFlowPart = Annotated[RealDriveFlow, Depends(part(RealDriveFlow))]
RunsPart = Annotated[SessionRuns, Depends(part(SessionRuns))]
FaultLogPart = Annotated[FaultLog, Depends(part(FaultLog))]
SpreadPart = Annotated[ClinicSpread, Depends(part(ClinicSpread))]
QualitiesPart = Annotated[TrialQualities, Depends(part(TrialQualities))]
LivePart = Annotated[ClinicLive, Depends(part(ClinicLive))]
ScreensPart = Annotated[Screens, Depends(part(Screens))]
PicturesPart = Annotated[ScreenPictures, Depends(part(ScreenPictures))]
DrivingScreenPart = Annotated[DrivingScreen, Depends(part(DrivingScreen))]
PairingPart = Annotated[PairingCodes, Depends(part(PairingCodes))]
PhonesPart = Annotated[PairedPhones, Depends(part(PairedPhones))]
PatientPicturePart = Annotated[PatientPicture, Depends(part(PatientPicture))]
PatientLivePart = Annotated[PatientLive, Depends(part(PatientLive))]
GraphicsPart = Annotated[Graphics, Depends(part(Graphics))]
MeasurementPart = Annotated[Measurement, Depends(part(Measurement))]
TrajectoriesPart = Annotated[Trajectories, Depends(part(Trajectories))]
TimelinesPart = Annotated[Timelines, Depends(part(Timelines))]
ReplaysPart = Annotated[Replays, Depends(part(Replays))]
ViewKeeperPart = Annotated[ViewKeeper, Depends(part(ViewKeeper))]
PlacesPart = Annotated[ClinicPlaces, Depends(part(ClinicPlaces))]


async def anyone_signed_in(person: WhoAsks) -> SignedInPerson:
    """Return the person who is signed in; 401 when nobody is, 423 when the sign-in is locked."""
    if person is None:
        raise HTTPException(401, NOBODY)
    if person.locked:
        raise HTTPException(423, LOCKED)
    return person


def viewer(role: Role, connection: HTTPConnection, database: Db, person: WhoAsks) -> SignedInPerson | PairedScreen:
    """Return who requests the 3D view of a role; the patient's is for the patient's screens, too.

    401 for nobody, 423 for a locked sign-in.
    """
    admitted = find_viewer(database, connection) if role == "patient" else person
    if admitted is None:
        raise HTTPException(401, NOBODY)
    if isinstance(admitted, SignedInPerson) and admitted.locked:
        raise HTTPException(423, LOCKED)
    return admitted


async def clinician(person: Annotated[SignedInPerson, Depends(anyone_signed_in)]) -> SignedInPerson:
    """Return the person who is signed in; 403 for reviewers, who may only look."""
    if not person.drives:
        raise HTTPException(403, Text("api-reviewer-changes-nothing"))
    return person


async def exporter(person: Annotated[SignedInPerson, Depends(anyone_signed_in)]) -> SignedInPerson:
    """Return the person who is signed in; 403 without the right to take reports and exports out of the clinic."""
    if person.role not in EXPORTERS:
        raise HTTPException(403, Text("api-reviewer-exports-nothing"))
    return person


async def owner(person: Annotated[SignedInPerson, Depends(anyone_signed_in)]) -> SignedInPerson:
    """Return the person who is signed in; 403 for those who are no owner of the clinic."""
    if person.role != "owner":
        raise HTTPException(403, Text("api-only-owners"))
    return person


async def everyone() -> None:
    """Mark a route that needs no sign-in; every route must be marked with a role (tests/api/test_roles.py)."""


ForEveryone = Depends(everyone)
Anyone = Annotated[SignedInPerson, Depends(anyone_signed_in)]
Clinician = Annotated[SignedInPerson, Depends(clinician)]
Exporter = Annotated[SignedInPerson, Depends(exporter)]
Owner = Annotated[SignedInPerson, Depends(owner)]
