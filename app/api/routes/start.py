"""What a page asks for when it starts, in one answer."""

from fastapi import APIRouter
from fastapi.requests import Request

from app.api.deps import Db, EquipmentPart, ForEveryone, SessionFlowPart, SettingsPart
from app.api.nearby import is_nearby
from app.api.routes.patients import CurrentSession, current_session
from app.api.sign_in.auth import Me, me_view
from app.api.who_asks import WhoAsks
from app.quantities import Document

router = APIRouter(tags=["start"])


class StartView(Document):
    """Who is signed in, the kind of a shirt that nobody wears, and the open session for who is signed in."""

    me: Me
    is_nearby: bool  # whether the page is in the building, where a person can see the chair
    practice: str | None
    session: CurrentSession | None  # None: nobody is signed in, or the page is locked


@router.get("/start", dependencies=[ForEveryone])
def start(
    request: Request,
    person: WhoAsks,
    settings: SettingsPart,
    database: Db,
    equipment: EquipmentPart,
    session_flow: SessionFlowPart,
) -> StartView:
    """Return what a page needs before it can show anything.

    Without sign-in: `me` as of `GET /auth/me`, `practice` as of `GET /equipment/practice`, `session` as of `GET
    /session` (null unless signed in).
    """
    return StartView(
        me=me_view(settings, database, person),
        is_nearby=is_nearby(request),
        practice=equipment.practice,
        session=None if person is None or person.locked else current_session(database, session_flow, person),
    )
