"""The people of the clinic, for owners: invite, choose rights, make a link for a new password, disable, enable."""

import asyncio
from typing import Annotated, Literal

from fastapi import APIRouter, Request
from fastapi.concurrency import run_in_threadpool
from pydantic import Field

from app.api.deps import Db, Owner, ReplaysPart, RowId, SettingsPart, SocketsPart
from app.api.own_address import link_hint, own_address
from app.api.page_session import OF_CLINIC, any_session
from app.api.qr import qr_picture
from app.api.sign_in.auth import PersonName
from app.quantities import Count, Document
from app.settings import Settings
from app.store.access.invitations import MadeInvitation, invite, open_invitation
from app.store.access.person_tables import Person
from app.store.access.rights import (
    PersonRole,
    change_rights,
    checked_patients,
    disable,
    enable,
    find_person_by_id,
    people_of,
)
from app.store.database import Transaction
from app.store.people import add_person
from app.store.tables import Clinic

router = APIRouter(prefix="/people", tags=["people"])

MOST_PATIENTS = 10_000  # of one reviewer

PatientIds = Annotated[list[Count], Field(max_length=MOST_PATIENTS)]


class Rights(Document):
    """What a person may do; a reviewer sees the chosen patients only, null: all."""

    role: PersonRole
    patients: PatientIds | None = None


class NewPerson(Rights):
    """A person to invite."""

    name: PersonName


class PersonView(Document):
    """A person of the clinic."""

    id: int
    name: str
    role: PersonRole
    patients: list[int] | None
    state: Literal["active", "invited", "disabled"]  # invited: has not chosen a password yet
    link_until: str | None  # when the open link of this person ends
    is_you: bool


class LinkView(Document):
    """A link by which a person chooses a password, shown once; `message`: where it does not work."""

    person: PersonView
    url: str
    qr: str
    expires: str
    message: str


def _view(db: Transaction, person: Person, own_id: int) -> PersonView:
    link = open_invitation(db, person)
    is_invited = person.password_hash is None and person.id != own_id
    return PersonView.model_validate(
        {
            "id": person.id,
            "name": person.name,
            "role": person.role,
            "patients": person.patients,
            "state": "disabled" if person.disabled else "invited" if is_invited else "active",
            "link_until": None if link is None else link.expires.isoformat(),
            "is_you": person.id == own_id,
        }
    )


async def _link(settings: Settings, request: Request, person: PersonView, invitation: MadeInvitation) -> LinkView:
    address = await asyncio.to_thread(own_address, settings, request)
    url = f"{address.base}#invite={invitation.code}"  # what is behind # is not sent to a server: no log has it
    return LinkView(
        person=person,
        url=url,
        qr=qr_picture(url),
        expires=invitation.expires.isoformat(),
        message=link_hint(settings, address),
    )


@router.get("")
def list_people(owner: Owner, database: Db) -> list[PersonView]:
    """List the people of the clinic.

    For owners. `patients` null: the person sees all.
    """
    with database.reading() as db:
        return [_view(db, person, owner.person_id) for person in people_of(db)]


@router.post("", status_code=201)
@any_session(OF_CLINIC)
async def invite_person(
    body: NewPerson, request: Request, owner: Owner, settings: SettingsPart, database: Db
) -> LinkView:
    """Add a person, and make the link by which this person chooses a password within 24 hours.

    For owners. The person has no password yet; `qr` of the link is SVG.
    """

    def _add() -> tuple[PersonView, MadeInvitation]:
        with database.transaction() as db:
            patients = checked_patients(db, body.role, body.patients)
            clinic = db.get_one(Clinic, owner.clinic_id)
            person = add_person(db, clinic, body.name, body.role, None, patients=patients, by=owner.name)
            invitation = invite(db, person, owner.name)
            return _view(db, person, owner.person_id), invitation

    return await _link(settings, request, *await run_in_threadpool(_add))


@router.post("/{person_id}/link", status_code=201)
@any_session(OF_CLINIC)
async def make_link(person_id: RowId, request: Request, owner: Owner, settings: SettingsPart, database: Db) -> LinkView:
    """Make a link by which a person chooses a new password; the old one holds until the link is used.

    For owners. The earlier link becomes invalid.
    """

    def _make() -> tuple[PersonView, MadeInvitation]:
        with database.transaction() as db:
            person = find_person_by_id(db, person_id)
            invitation = invite(db, person, owner.name)
            return _view(db, person, owner.person_id), invitation

    return await _link(settings, request, *await run_in_threadpool(_make))


@router.put("/{person_id}")
@any_session(OF_CLINIC)
async def choose_rights(
    person_id: RowId, body: Rights, owner: Owner, database: Db, sockets: SocketsPart, replays: ReplaysPart
) -> PersonView:
    """Give a person another role or other patients; when they change, the person has to sign in again.

    For owners. 409 for the last owner who can sign in.
    """

    def _choose() -> tuple[PersonView, bool]:
        with database.transaction() as db:
            person = find_person_by_id(db, person_id)
            before = (person.role, person.patients)
            patients = checked_patients(db, body.role, body.patients)
            change_rights(db, person, body.role, patients, owner.name)
            return _view(db, person, owner.person_id), before != (person.role, person.patients)

    view, has_changed = await run_in_threadpool(_choose)
    if has_changed:
        await sockets.close_person(person_id)
        await asyncio.to_thread(replays.close_of, person_id)
    return view


@router.post("/{person_id}/disable")
@any_session(OF_CLINIC)
async def disable_person(
    person_id: RowId, owner: Owner, database: Db, sockets: SocketsPart, replays: ReplaysPart
) -> PersonView:
    """Let a person sign in no longer; every sign-in and socket of this person ends at once.

    For owners. No known browser and no link is left. 409 for the last owner who can sign in.
    """

    def _disable() -> PersonView:
        with database.transaction(closing=True) as db:
            person = find_person_by_id(db, person_id)
            disable(db, person, owner.name)
            return _view(db, person, owner.person_id)

    view = await run_in_threadpool(_disable)
    await sockets.close_person(person_id)
    await asyncio.to_thread(replays.close_of, person_id)
    return view


@router.post("/{person_id}/enable")
@any_session(OF_CLINIC)
def enable_person(person_id: RowId, owner: Owner, database: Db) -> PersonView:
    """Let a disabled person sign in again."""
    with database.transaction() as db:
        person = find_person_by_id(db, person_id)
        enable(db, person, owner.name)
        return _view(db, person, owner.person_id)
