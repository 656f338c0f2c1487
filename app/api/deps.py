"""Dependencies of the routes: settings and database, and the person who is signed in with the needed right."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from fastapi import Depends, HTTPException, Path
from starlette.requests import HTTPConnection

from app.api.foreign_files import OneAtATime
from app.api.sign_in.hashing import Hashing
from app.api.sign_in.identity import PairedScreen, SignedInPerson, find_viewer
from app.api.sign_in.set_up import SetUp
from app.api.sign_in.sign_in_limits import SignInLimits
from app.api.sockets import OpenSockets
from app.api.who_asks import WhoAsks
from app.scene.role_servers import Role
from app.settings import Settings
from app.store.database import Database
from app.store.files.plans import OwnPlans
from app.store.files.replacements import ReplacedFiles

if TYPE_CHECKING:
    from app.api.package_download import ExportCourses

RowId = Annotated[int, Path(ge=1, le=2**31)]

EXPORTERS = frozenset({"owner", "clinician"})  # may take reports and exports out of the clinic
LOCKED = "This page is locked: give the password, or let somebody else sign in."
NOBODY = "You are not signed in, or no longer: sign in again."


@dataclass(slots=True)
class People:
    """Settings, database, the clinic's files, and the parts that decide who may sign in."""

    settings: Settings
    database: Database
    hashing: Hashing
    limits: SignInLimits
    set_up: SetUp
    sockets: OpenSockets
    replaced: ReplacedFiles
    own_plans: OwnPlans
    readings: OneAtATime  # of drawings, pictures and 3D objects
    uploads: OneAtATime  # of recordings, each in memory as a whole
    exports: "ExportCourses"


async def people(connection: HTTPConnection) -> People:
    """Return these parts; async, because Stop needs them and must not wait for a thread."""
    found: People = connection.app.state.people
    return found


PeopleParts = Annotated[People, Depends(people)]


async def anyone_signed_in(who: WhoAsks) -> SignedInPerson:
    """Return the person who is signed in; 401 when nobody is, 423 when the sign-in is locked."""
    if who is None:
        raise HTTPException(401, NOBODY)
    if who.locked:
        raise HTTPException(423, LOCKED)
    return who


def viewer(role: Role, connection: HTTPConnection, parts: PeopleParts, who: WhoAsks) -> SignedInPerson | PairedScreen:
    """Return who requests the 3D view of a role; the patient's is for the patient's screens, too.

    401 for nobody, 423 for a locked sign-in.
    """
    found = find_viewer(parts.database, connection) if role == "patient" else who
    if found is None:
        raise HTTPException(401, NOBODY)
    if isinstance(found, SignedInPerson) and found.locked:
        raise HTTPException(423, LOCKED)
    return found


async def clinician(who: Annotated[SignedInPerson, Depends(anyone_signed_in)]) -> SignedInPerson:
    """Return the person who is signed in; 403 for reviewers, who may only look."""
    if not who.drives:
        raise HTTPException(
            403, "A reviewer reads and comments, and changes nothing else: ask an owner for more rights."
        )
    return who


async def exporter(who: Annotated[SignedInPerson, Depends(anyone_signed_in)]) -> SignedInPerson:
    """Return the person who is signed in; 403 without the right to take reports and exports out of the clinic."""
    if who.role not in EXPORTERS:
        raise HTTPException(
            403, "A reviewer takes no records out of the clinic: ask a clinician for a report or an export."
        )
    return who


async def owner(who: Annotated[SignedInPerson, Depends(anyone_signed_in)]) -> SignedInPerson:
    """Return the person who is signed in; 403 for those who are no owner of the clinic."""
    if who.role != "owner":
        raise HTTPException(403, "Only an owner of the clinic changes this: ask one.")
    return who


async def everyone() -> None:
    """Mark a route that needs no sign-in; every route must be marked with a role (tests/api/test_roles.py)."""


ForEveryone = Depends(everyone)
Anyone = Annotated[SignedInPerson, Depends(anyone_signed_in)]
Clinician = Annotated[SignedInPerson, Depends(clinician)]
Exporter = Annotated[SignedInPerson, Depends(exporter)]
Owner = Annotated[SignedInPerson, Depends(owner)]
