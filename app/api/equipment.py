"""The shirt, what moves inside it, its channels, and the files that people bring."""

import asyncio
import shutil
from pathlib import Path
from typing import Annotated, Any

from fastapi import APIRouter, UploadFile
from pydantic import Field

from app.api.deps import Anyone, Clinician, PeopleParts
from app.api.flows import FlowParts, Flows
from app.api.uploads import FileView, keep_upload, list_files
from app.hardware.configs import BodyConfig, HeadConfig, ShirtConfig
from app.layout import MAX_CHANNELS, ShirtLayout
from app.quantities import Document, Name
from app.session.control import Control
from app.session.refusals import Refusal
from app.session.same_name import SameName, logged
from app.session.store_log import write_log

LITTLE_ROOM = 2_000_000_000  # bytes: somebody should make room, and there is still time to
LEAST_ROOM = 500_000_000  # bytes: from there on the control process refuses to record

router = APIRouter(prefix="/equipment", tags=["equipment"])


class Unused(Document):
    """Channels to leave out."""

    channels: Annotated[list[Name], Field(max_length=MAX_CHANNELS)]


class ChosenHead(Document):
    """A head tracker, None for none."""

    config: HeadConfig | None


class StatusView(Document):
    """How the shirt and the control process are, in words."""

    words: str
    alive: bool
    sample_rate: float
    lost: int
    realtime: list[str]
    control: str


class ChairView(Document):
    """Which chair is driven."""

    words: str


class HeadView(Document):
    """Which head tracker looks."""

    config: dict[str, Any] | None
    words: str


class DiskView(Document):
    """How much room is left for recordings."""

    free: int  # bytes
    words: str  # what to do about it, empty while there is enough


class EquipmentView(Document):
    """Everything that is connected."""

    shirt: dict[str, Any]
    body: dict[str, Any] | None
    layout: ShirtLayout | None
    unused: list[str]
    status: StatusView
    files: list[FileView]
    chair: ChairView
    head: HeadView
    disk: DiskView


async def _status(control: Control, flows: Flows) -> tuple[StatusView, HeadView]:
    worn, head = flows.equipment, flows.head.config
    try:
        status = await control.call("status")
    except Refusal as refusal:
        return StatusView(
            words=str(refusal), alive=False, sample_rate=worn.sample_rate, lost=0, realtime=[], control=control.state
        ), HeadView(config=head, words=str(refusal))
    shirt = status.get("shirt") or {}
    shown = StatusView(
        words=worn.words or str(shirt.get("words", "")),
        alive=bool(shirt.get("alive", False)),
        sample_rate=float(shirt.get("sample_rate") or worn.sample_rate),
        lost=int(shirt.get("lost") or 0),
        realtime=[str(sentence) for sentence in status.get("realtime", [])],
        control=control.state,
    )
    return shown, HeadView(config=head, words=flows.head.words or str((status.get("head") or {}).get("words", "")))


async def _view(parts: PeopleParts, flows: Flows) -> EquipmentView:
    worn = flows.equipment
    status, head = await _status(flows.control, flows)
    return EquipmentView(
        shirt=worn.shirt,
        body=worn.body,
        layout=worn.layout,
        unused=worn.unused,
        status=status,
        files=await asyncio.to_thread(list_files, parts.settings.files),
        chair=ChairView(words=await flows.chairs.state()),
        head=head,
        disk=await asyncio.to_thread(_disk, parts.settings.state),
    )


def _disk(folder: Path) -> DiskView:
    free = shutil.disk_usage(folder).free
    words = ""
    if free < LITTLE_ROOM:
        words = (
            f"Only {free / 1e9:.1f} GB are free on the disk of the recordings, and below "
            f"{LEAST_ROOM / 1e9:.1f} GB nothing is recorded or driven any more: make room."
        )
    return DiskView(free=free, words=words)


@router.get("")
async def look(_who: Anyone, parts: PeopleParts, flows: FlowParts) -> EquipmentView:
    """Return everything that is connected."""
    return await _view(parts, flows)


async def _noted(parts: PeopleParts, flows: Flows, person: str, what: str, **details: Any) -> EquipmentView:
    def _write() -> None:
        with parts.database.transaction() as db:
            write_log(db, person, what, **details)

    await asyncio.to_thread(_write)
    return await _view(parts, flows)


@router.put("/shirt")
async def choose_shirt(body: ShirtConfig, who: Clinician, parts: PeopleParts, flows: FlowParts) -> EquipmentView:
    """Open another shirt; when it does not open, the one before stays."""
    config = body.model_dump(mode="json")
    async with flows.visit.undisturbed("change the shirt"):
        try:
            await flows.equipment.use_shirt(config)
        finally:
            await flows.visit.try_load_parameters()
    return await _noted(parts, flows, who.name, "shirt chosen", kind=config["kind"])


@router.put("/body")
async def choose_body(body: BodyConfig, who: Clinician, parts: PeopleParts, flows: FlowParts) -> EquipmentView:
    """Let somebody else move inside the simulated shirt."""
    config = body.model_dump(mode="json")
    async with flows.visit.undisturbed("change the body"):
        await flows.equipment.use_body(config)
    return await _noted(parts, flows, who.name, "body chosen", kind=config["kind"])


@router.put("/head")
async def choose_head(body: ChosenHead, who: Clinician, parts: PeopleParts, flows: FlowParts) -> EquipmentView:
    """Look with another head tracker, or with none."""
    config = None if body.config is None else body.config.model_dump(mode="json")
    async with flows.visit.undisturbed("change the head tracker"):
        await flows.head.use(config)
    return await _noted(parts, flows, who.name, "head tracker chosen", kind=config["kind"] if config else None)


@router.post("/head/ahead")
async def look_ahead(_who: Clinician, parts: PeopleParts, flows: FlowParts) -> EquipmentView:
    """Count where the head looks now as straight ahead."""
    await flows.head.set_ahead()
    return await _view(parts, flows)


@router.put("/unused")
async def mark_unused(body: Unused, who: Clinician, parts: PeopleParts, flows: FlowParts) -> EquipmentView:
    """Mark channels as unused; the next calibration leaves them out."""
    async with flows.visit.undisturbed("change the channels"):
        await flows.equipment.leave_unused(body.channels)
    return await _noted(parts, flows, who.name, "channels marked", unused=flows.equipment.unused)


@router.post("/files", status_code=201)
async def bring_file(
    file: UploadFile, who: Clinician, parts: PeopleParts, flows: FlowParts, same_name: SameName = "ask"
) -> EquipmentView:
    """Take in a file of recorded signals or of a recorded body; `same_name` says what becomes of one of this name."""
    kept = await asyncio.to_thread(keep_upload, parts.replaced, file.filename or "", file.file, same_name)
    flows.live.tell("equipment")
    return await _noted(parts, flows, who.name, "file added", kind=kept.kind, size=kept.size, **logged(same_name))
