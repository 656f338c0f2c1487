"""Real chairs: paired and unpaired by an owner, chosen by a clinician."""

import asyncio

from fastapi import APIRouter

from app.api.answers import Answer, MomentText
from app.api.deps import Anyone, ChairsPart, Db, LivePart, Owner, RowId, SessionFlowPart, SettingsPart
from app.api.page_session import OF_CLINIC, ClinicianInSession, any_session
from app.api.qr import qr_picture
from app.api.sign_in.identity import SignedInPerson
from app.hardware.addresses import Host
from app.hardware.chair.key import Key
from app.hardware.configs import ReceiverPort
from app.news import News
from app.ports import RECEIVER_PORT
from app.quantities import Document, Title
from app.session.equipment.chairs import Chairs, Dynamics
from app.session.equipment.pairing import pair_chair, unpair_chair
from app.speed_limits import Speeds
from app.store.chairs import chairs_of, find_chair
from app.store.database import Database
from app.store.log import write_log
from app.store.tables import Clinic, PairedChair
from app.texts import Text

router = APIRouter(prefix="/chairs", tags=["chairs"])


class NewChair(Document):
    """A chair to pair: where its receiver listens, and what it may do."""

    name: Title
    host: Host
    port: ReceiverPort = RECEIVER_PORT
    speeds: Speeds


class Choice(Document):
    """The chair to drive, None for the virtual one, and the dynamics of the virtual one."""

    id: RowId | None
    dynamics: Dynamics


class ChairView(Answer):
    """A paired chair."""

    id: int
    name: str
    host: str
    port: int
    key_id: int
    speeds: Speeds
    paired: MomentText


class ChairsView(Document):
    """The paired chairs, and the one in use."""

    chairs: list[ChairView]
    chosen: int | None
    dynamics: Dynamics
    message: Text | str


class PairedView(ChairsView):
    """The paired chairs with the key of the new one, which is shown only this once."""

    key_line: str
    qr: str


async def _view(database: Database, chairs: Chairs) -> ChairsView:
    def _read() -> list[ChairView]:
        with database.reading() as db:
            return [ChairView.of(chair) for chair in chairs_of(db)]

    chosen = chairs.chosen
    return ChairsView(
        chairs=await asyncio.to_thread(_read),
        chosen=None if chosen is None else chosen.id,
        dynamics=chairs.dynamics,
        message=await chairs.state(),
    )


@router.get("")
async def read_chairs(_person: Anyone, database: Db, chairs: ChairsPart) -> ChairsView:
    """Return the chairs."""
    return await _view(database, chairs)


@router.post("", status_code=201)
@any_session(OF_CLINIC)
async def pair(
    body: NewChair, person: Owner, settings: SettingsPart, database: Db, chairs: ChairsPart, live: LivePart
) -> PairedView:
    """Pair a chair: make its key, store it in a file on this machine, and show it this once.

    For owners. `key_line` and `qr` (SVG) are answered this once.
    """

    def _pair() -> Key:
        with database.transaction() as db:
            clinic = db.get_one(Clinic, person.clinic_id)
            keys = settings.keys
            chair, key = pair_chair(db, clinic, keys, body.name, body.host, body.port, body.speeds)
            write_log(db, person.name, "chair paired", chair=chair.id, key_id=key.id, host=body.host, port=body.port)
            return key

    key = await asyncio.to_thread(_pair)
    live.notify(News(what="equipment"))
    view = await _view(database, chairs)
    return PairedView(**view.model_dump(), key_line=key.line, qr=qr_picture(key.line))


@router.delete("/{chair_id}")
@any_session(OF_CLINIC)
async def unpair(
    chair_id: RowId,
    person: Owner,
    settings: SettingsPart,
    database: Db,
    chairs: ChairsPart,
    session_flow: SessionFlowPart,
    live: LivePart,
) -> ChairsView:
    """Unpair a chair and delete its key; if it is in use, the virtual chair is used instead.

    For owners.
    """

    def _unpair() -> None:
        with database.transaction(closing=True) as db:
            chair = unpair_chair(db, settings.keys, chair_id)
            write_log(db, person.name, "chair unpaired", chair=chair.id, key_id=chair.key_id)

    async with session_flow.undisturbed():
        if chairs.chosen is not None and chairs.chosen.id == chair_id:
            await chairs.choose(None, chairs.dynamics)
        await asyncio.to_thread(_unpair)
    live.notify(News(what="equipment"))
    return await _view(database, chairs)


@router.put("/chosen")
async def choose(
    body: Choice, person: ClinicianInSession, database: Db, chairs: ChairsPart, session_flow: SessionFlowPart
) -> ChairsView:
    """Use another chair."""
    async with session_flow.undisturbed():
        chair = None if body.id is None else await asyncio.to_thread(_find, database, body.id)
        await chairs.choose(chair, body.dynamics)
    await asyncio.to_thread(_note, database, person, body)
    return await _view(database, chairs)


def _find(database: Database, chair_id: int) -> PairedChair:
    with database.reading() as db:
        return find_chair(db, chair_id)


def _note(database: Database, person: SignedInPerson, choice: Choice) -> None:
    with database.transaction() as db:
        write_log(db, person.name, "chair chosen", chair=choice.id, dynamics=choice.dynamics)
