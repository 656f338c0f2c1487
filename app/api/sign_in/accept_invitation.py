"""The page that an invitation opens: for whom it is, and the password that this person chooses."""

from fastapi import APIRouter, HTTPException, Request, Response
from fastapi.concurrency import run_in_threadpool

from app.api.deps import Db, ForEveryone, SettingsPart, SignInLimitsPart, SocketsPart
from app.api.page_session import SIGN_IN, any_session
from app.api.sign_in.auth import Code, Me, Password, let_in
from app.api.sign_in.passwords import Passwords, weakness
from app.api.sign_in.sign_in_limits import SignInLimits, address_of
from app.quantities import Document
from app.store.access.invitations import VALID_FOR, accept_invitation, find_invited
from app.store.database import Database
from app.texts import Text

router = APIRouter(prefix="/auth/invitation", tags=["sign-in"], dependencies=[ForEveryone])

WRONG = Text("api-link-wrong", hours=round(VALID_FOR.total_seconds() / 3600))


class InvitationCode(Document):
    """The code in the link of an invitation."""

    code: Code


class AcceptedInvitation(Document):
    """The code in the link, and the password that the person has chosen."""

    code: Code
    password: Password


class InvitedView(Document):
    """For whom an invitation is."""

    name: str
    role: str
    is_new: bool  # False: the person is there, and chooses another password


class _Invited(Document):
    person_id: int
    view: InvitedView


async def _require_invited(database: Database, sign_in_limits: SignInLimits, request: Request, code: str) -> _Invited:
    """Return for whom a code is valid; 401 for a wrong one, which is counted by address."""
    attempt = await sign_in_limits.code(address_of(request))
    invitation = await run_in_threadpool(_find, database, code)
    if invitation is None:
        raise HTTPException(401, WRONG)
    attempt.take_back()
    return invitation


def _find(database: Database, code: str) -> _Invited | None:
    with database.reading() as db:
        person = find_invited(db, code)
        if person is None:
            return None
        view = InvitedView(name=person.name, role=person.role, is_new=person.password_hash is None)
        return _Invited(person_id=person.id, view=view)


@router.post("")
@any_session(SIGN_IN)
async def read_invitation(
    body: InvitationCode, request: Request, database: Db, sign_in_limits: SignInLimitsPart
) -> InvitedView:
    """Tell for whom an invitation is; it stays valid.

    Without sign-in. The code stands behind `#invite=` of the link, is valid once and for 24 hours, and is stored as
    SHA-256; 401 for any other.
    """
    return (await _require_invited(database, sign_in_limits, request, body.code)).view


@router.post("/accept")
@any_session(SIGN_IN)
async def accept(
    body: AcceptedInvitation,
    request: Request,
    response: Response,
    passwords: Passwords,
    settings: SettingsPart,
    database: Db,
    sign_in_limits: SignInLimitsPart,
    sockets: SocketsPart,
) -> Me:
    """Give the invited person the password and sign them in; other sign-ins of the person end."""
    invited = await _require_invited(database, sign_in_limits, request, body.code)
    weak = weakness(invited.view.name, body.password)
    if weak is not None:
        raise HTTPException(422, weak)
    password_hash = await passwords.hash_of(body.password)

    def _accept() -> Me:
        with database.transaction() as db:
            person = find_invited(db, body.code)
            if person is None:  # used by somebody else while the password was being hashed
                raise HTTPException(401, WRONG)
            accept_invitation(db, person, password_hash)
        return let_in(settings, database, request, response, invited.view.name, "invitation")

    me = await run_in_threadpool(_accept)
    await sockets.close_person(invited.person_id)
    return me
