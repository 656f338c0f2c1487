"""The change of the own password; it needs the old one, and ends the person's other sign-ins."""

from fastapi import APIRouter, HTTPException, Request
from fastapi.concurrency import run_in_threadpool

from app.api.deps import Anyone, Db, SocketsPart
from app.api.page_session import SIGN_IN, any_session
from app.api.sign_in.auth import Password
from app.api.sign_in.passwords import Passwords, weakness
from app.quantities import Document
from app.store.access.rights import end_sign_ins, find_person_by_id
from app.store.log import write_log

router = APIRouter(prefix="/auth", tags=["sign-in"])


class PasswordChange(Document):
    """The old and the new password."""

    old: Password
    new: Password


@router.put("/password", status_code=204)
@any_session(SIGN_IN)
async def change_password(
    body: PasswordChange,
    request: Request,
    signed_in: Anyone,
    passwords: Passwords,
    database: Db,
    sockets: SocketsPart,
) -> None:
    """Change the own password: every other sign-in of this person ends, and known browsers are forgotten."""
    weak = weakness(signed_in.name, body.new)
    if weak is not None:
        raise HTTPException(422, weak)
    await passwords.require_own(request, signed_in.name, body.old)
    password_hash = await passwords.hash_of(body.new)

    def _change() -> None:
        with database.transaction() as db:
            person = find_person_by_id(db, signed_in.person_id)
            person.password_hash = password_hash
            end_sign_ins(db, person, but=signed_in.sign_in_id)
            write_log(db, signed_in.name, "password changed", person=person.id)

    await run_in_threadpool(_change)
    await sockets.close_person(signed_in.person_id, but=signed_in.sign_in_id)
