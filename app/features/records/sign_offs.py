"""Sign a session off, and unlock it."""

import asyncio
from typing import Annotated

from fastapi import APIRouter
from pydantic import Field

from app.api.deps import Clinician, Db, LivePart, Owner, RowId, SessionFlowPart, SocketsPart, ViewKeeperPart
from app.api.page_session import OWN_NAME, any_session
from app.features.records.session_views import SessionRecordView, record_view
from app.features.records.sign_off import sign_off, unlock
from app.quantities import Document, Line
from app.store.log import write_log
from app.store.patients import find_session

router = APIRouter(tags=["records"])


class Unlock(Document):
    """Why a signed session is unlocked."""

    reason: Annotated[Line, Field(min_length=1, max_length=200, pattern=r"\S")]


@router.post("/sessions/{session_id}/sign-off", status_code=201)
@any_session(OWN_NAME)
async def sign_session_off(
    session_id: RowId,
    who: Clinician,
    database: Db,
    sockets: SocketsPart,
    session_flow: SessionFlowPart,
    live: LivePart,
    view_keeper: ViewKeeperPart,
) -> SessionRecordView:
    """Sign a session off: nothing of it can be changed any more. The open session ends with it.

    409 during a step, trial or drive.
    """

    def _sign() -> tuple[SessionRecordView, bool]:
        with database.transaction() as db:
            session = find_session(db, who.clinic_id, session_id)
            was_open = session.ended is None
            sign_off(db, session, who.name)
            write_log(db, who.name, "session signed off", patient=session.patient_id, session=session_id)
            return record_view(db, session), was_open

    async with session_flow.undisturbed("sign off"):
        answer, was_open = await asyncio.to_thread(_sign)
        if was_open:
            await sockets.close_ended_screens()
            await view_keeper.close()
            await session_flow.session_changed()
    live.tell("record")
    return answer


@router.post("/sessions/{session_id}/unlock")
@any_session(OWN_NAME)
def unlock_session(session_id: RowId, body: Unlock, who: Owner, database: Db, live: LivePart) -> SessionRecordView:
    """Unlock a signed session, for a reason, which stays with its sign-off in the history of the session.

    For owners.
    """
    with database.transaction() as db:
        session = find_session(db, who.clinic_id, session_id)
        row = unlock(db, session, who.name, body.reason)
        details = {"patient": session.patient_id, "session": session_id, "signed_by": row.person}
        write_log(db, who.name, "session unlocked", **details)
        answer = record_view(db, session)
    live.tell("record")
    return answer
