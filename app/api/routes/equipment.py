"""The shirt, what moves inside it, its channels, and the files that people bring."""

import asyncio
from dataclasses import dataclass
from typing import Annotated, Any

from fastapi import APIRouter, Depends, UploadFile
from pydantic import Field

from app.api.deps import (
    Anyone,
    ComputingPart,
    ControlPart,
    Db,
    EquipmentPart,
    ForEveryone,
    HeadPart,
    LivePart,
    ReplacedFilesPart,
    SessionFlowPart,
    UploadsPart,
)
from app.api.page_session import ClinicianInSession
from app.api.parts import parts_for
from app.api.routes.signal_uploads import FileView, keep_upload, list_files
from app.computing_process import ComputingProcess
from app.hardware.configs import KINDS, AnyShirtConfig, BodyConfig, HeadConfig
from app.hardware.shirt.kind import ShirtKind
from app.layout import MAX_CHANNELS, ShirtLayout
from app.news import News
from app.quantities import Document, Line, Name
from app.refusals import Refusal
from app.session.control_link import ControlLink
from app.session.equipment.chairs import Chairs
from app.session.equipment.head import HeadChoice
from app.session.equipment.shirt import Equipment
from app.settings import Settings
from app.store.database import Database
from app.store.files.disk_watch import disk_room
from app.store.files.name_conflicts import SameName, log_details
from app.store.keeping.patient_files import add_patient_file
from app.store.log import write_log
from app.texts import Text, from_document, text_of

router = APIRouter(prefix="/equipment", tags=["equipment"])


class UnusedChannels(Document):
    """The names of the unused channels."""

    channels: Annotated[list[Name], Field(max_length=MAX_CHANNELS)]


class HeadTrackerChoice(Document):
    """A head tracker to use, None for none."""

    config: HeadConfig | None


class StatusView(Document):
    """The state of the shirt and the control process."""

    message: Text | str
    alive: bool
    sample_rate: float
    lost: int
    found: list[str]  # names of the sensors that the shirt has found, and that nobody has placed on the body
    realtime: list[Text | str]
    control: str


class ChairStateView(Document):
    """The state of the chair in use, in words."""

    message: Text | str


class HeadTrackerView(Document):
    """The head tracker in use."""

    config: dict[str, Any] | None
    message: Text | str


class DiskView(Document):
    """The free room for recordings."""

    free: int  # bytes
    message: str  # what to do about it, empty while there is enough


class SendersView(Document):
    """The senders of frames to the port of the shirt; every field is empty for a shirt that is not on the network."""

    shirt: str  # HOST:PORT of the sender that is the shirt, empty before its first frame
    other: str  # HOST:PORT of another sender of good frames, empty when there is none
    others: int  # number of frames of other senders that were left out


class ChosenSender(Document):
    """The sender to take as the shirt."""

    sender: Annotated[Line, Field(min_length=1, max_length=100)]


class ShirtKindView(Document):
    """A kind of shirt to choose."""

    kind: str
    simulated: bool  # whether nobody wears it
    network: bool  # whether people choose the sender of its frames
    may_arm: Text | str  # whether it may drive a real chair, with the reason
    form: dict[str, Any]  # the JSON schema of its configuration, of which the page makes the form


class PracticeShirt(Document):
    """The kind of the shirt in use when nobody wears that shirt; None when somebody wears it, or without a shirt."""

    kind: str | None


class EquipmentView(Document):
    """The equipment in use, and what can be chosen."""

    shirt: dict[str, Any] | None  # None: nobody has chosen one yet
    simulated: bool | None  # whether nobody wears the chosen shirt: then it is for practice only
    body: dict[str, Any] | None
    layout: ShirtLayout | None
    unused: list[str]
    status: StatusView
    files: list[FileView]
    shirt_keys: list[str]
    chair: ChairStateView
    head: HeadTrackerView
    disk: DiskView


@dataclass(frozen=True, slots=True)
class EquipmentState:
    """The equipment in use, as the page shows it."""

    settings: Settings
    database: Database
    computing: ComputingProcess
    control: ControlLink
    equipment: Equipment
    chairs: Chairs
    head: HeadChoice

    async def view(self) -> EquipmentView:
        """Return the equipment in use, and what can be chosen."""
        equipment = self.equipment
        status, head = await self._status()
        room = await asyncio.to_thread(disk_room, self.settings.state)
        return EquipmentView(
            shirt=equipment.shirt,
            simulated=equipment.simulated,
            body=equipment.body,
            layout=equipment.layout,
            unused=equipment.unused,
            status=status,
            files=await asyncio.to_thread(list_files, self.settings.files, self.computing),
            shirt_keys=await asyncio.to_thread(lambda: equipment.key_names),
            chair=ChairStateView(message=await self.chairs.state()),
            head=head,
            disk=DiskView(free=room.free, message=str(room.message or "")),
        )

    async def logged_view(self, person: str, what: str, **details: Any) -> EquipmentView:
        """Log what a person has changed, and return the equipment in use."""

        def write() -> None:
            with self.database.transaction() as db:
                write_log(db, person, what, **details)

        await asyncio.to_thread(write)
        return await self.view()

    async def _status(self) -> tuple[StatusView, HeadTrackerView]:
        equipment, config = self.equipment, self.head.config
        try:
            status = await self.control.call("status")
        except Refusal as refusal:
            return StatusView(
                message=text_of(refusal),
                alive=False,
                sample_rate=equipment.sample_rate,
                lost=0,
                found=[],
                realtime=[],
                control=self.control.state,
            ), HeadTrackerView(config=config, message=text_of(refusal))
        shirt = status.get("shirt") or {}
        view = StatusView(
            message=equipment.failure or from_document(shirt.get("words", "")),
            alive=bool(shirt.get("alive", False)),
            sample_rate=float(shirt.get("sample_rate") or equipment.sample_rate),
            lost=int(shirt.get("lost") or 0),
            found=list(shirt.get("found") or ()),
            realtime=[from_document(sentence) for sentence in status.get("realtime", [])],
            control=self.control.state,
        )
        message = self.head.failure or from_document((status.get("head") or {}).get("words", ""))
        return view, HeadTrackerView(config=config, message=message)


State = Annotated[EquipmentState, Depends(parts_for(EquipmentState))]


@router.get("")
async def read_equipment(_person: Anyone, state: State) -> EquipmentView:
    """Return the equipment in use, and what can be chosen.

    `shirt` null: none chosen yet. `disk.message` is empty above 2 GB and changes within a second (news `disk`).
    """
    return await state.view()


@router.get("/shirts")
def list_shirts(_person: Anyone) -> list[ShirtKindView]:
    """Return the kinds of shirts that can be chosen.

    `form` is the JSON schema of a configuration, of which the page makes the form (docs/drivers.md).
    """
    return [shirt_kind_view(kind) for kind in KINDS]


def shirt_kind_view(kind: ShirtKind[Any]) -> ShirtKindView:
    """Return what a page needs of a kind of shirt."""
    return ShirtKindView(
        kind=kind.name,
        simulated=kind.simulated,
        network=kind.is_on_network,
        may_arm=kind.may_arm,
        form=kind.config.model_json_schema(),
    )


@router.get("/practice", dependencies=[ForEveryone])
def practice(equipment: EquipmentPart) -> PracticeShirt:
    """Return whether pages have to show the mark "practice only"; also for pages without a sign-in."""
    return PracticeShirt(kind=equipment.practice)


@router.put("/shirt")
async def choose_shirt(
    body: AnyShirtConfig,
    person: ClinicianInSession,
    state: State,
    equipment: EquipmentPart,
    session_flow: SessionFlowPart,
) -> EquipmentView:
    """Open another shirt; when it does not open, the one before stays.

    `file` is a name from `files` of `GET /equipment`, `key_file` one from `shirt_keys`.
    """
    config = body.model_dump(mode="json")
    async with session_flow.undisturbed():
        try:
            await equipment.use_shirt(config)
        finally:
            await session_flow.try_load_parameters()
    return await state.logged_view(person.name, "shirt chosen", kind=config["kind"])


@router.get("/sender")
async def read_senders(_person: Anyone, control: ControlPart) -> SendersView:
    """Return who sends frames to the shirt's port."""
    status = await control.call("status")
    return SendersView.model_validate(status["shirt"].get("senders") or {"shirt": "", "other": "", "others": 0})


@router.put("/sender")
async def choose_sender(
    body: ChosenSender,
    person: ClinicianInSession,
    state: State,
    equipment: EquipmentPart,
    session_flow: SessionFlowPart,
) -> EquipmentView:
    """Take another sender as the shirt; refused while anything is armed, driven or recorded.

    It is logged.
    """
    async with session_flow.undisturbed():
        await equipment.use_sender(body.sender)
    return await state.logged_view(person.name, "shirt's sender chosen", sender=body.sender)


@router.put("/body")
async def choose_body(
    body: BodyConfig, person: ClinicianInSession, state: State, equipment: EquipmentPart, session_flow: SessionFlowPart
) -> EquipmentView:
    """Choose another simulated body for the simulated shirt.

    `file` is a name from `files` of `GET /equipment`.
    """
    config = body.model_dump(mode="json")
    async with session_flow.undisturbed():
        await equipment.use_body(config)
    return await state.logged_view(person.name, "body chosen", kind=config["kind"])


@router.put("/head")
async def choose_head(
    body: HeadTrackerChoice, person: ClinicianInSession, state: State, head: HeadPart, session_flow: SessionFlowPart
) -> EquipmentView:
    """Use another head tracker, or none.

    `file` is a name from `files` of `GET /equipment`.
    """
    config = None if body.config is None else body.config.model_dump(mode="json")
    async with session_flow.undisturbed():
        await head.use(config)
    return await state.logged_view(person.name, "head tracker chosen", kind=config["kind"] if config else None)


@router.post("/head/ahead")
async def look_ahead(_person: ClinicianInSession, state: State, head: HeadPart) -> EquipmentView:
    """Count where the head looks now as straight ahead."""
    await head.set_ahead()
    return await state.view()


@router.put("/unused")
async def mark_unused(
    body: UnusedChannels,
    person: ClinicianInSession,
    state: State,
    equipment: EquipmentPart,
    session_flow: SessionFlowPart,
) -> EquipmentView:
    """Mark channels as unused; the next calibration leaves them out."""
    async with session_flow.undisturbed():
        await equipment.leave_unused(body.channels)
    return await state.logged_view(person.name, "channels marked", unused=equipment.unused)


@router.post("/files", status_code=201)
async def bring_file(
    file: UploadFile,
    person: ClinicianInSession,
    *,
    state: State,
    database: Db,
    replaced: ReplacedFilesPart,
    uploads: UploadsPart,
    computing: ComputingPart,
    live: LivePart,
    same_name: SameName = "ask",
) -> EquipmentView:
    """Store a file of recorded signals or of a recorded body; `same_name`: what to do when its name is taken.

    The multipart field `file`: CSV or Parquet, at most 64 MB and 40 million numbers. It belongs to the patient whose
    session is open.
    """
    stored = await uploads.run(keep_upload, replaced, computing, file.filename or "", file.file, same_name)

    def note_patient() -> None:
        with database.transaction() as db:
            add_patient_file(db, stored.name)

    await asyncio.to_thread(note_patient)
    live.notify(News(what="equipment"))
    return await state.logged_view(
        person.name,
        "file added",
        kind=stored.kind,
        size=stored.size,
        **log_details(same_name),
    )
