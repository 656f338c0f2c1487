"""The patient's screens: paired for one session, found by their token, with the settings of what they show."""

import hashlib
import secrets
from datetime import timedelta
from typing import Annotated, Literal

from pydantic import Field, StrictBool
from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.quantities import Document, Line
from app.refusals import Conflict, NotFound
from app.store.log import write_log
from app.store.own_rows import own_row
from app.store.tables import PatientScreen, PatientSession
from app.texts import Text

TOKEN_BYTES = 32
PAIRED_FOR = timedelta(hours=12)  # longer than a session; limits the pairing when a session is never ended
MOST = 8  # screens of one session; one or two are usual

ScreenState = Literal["paired", "over", "unpaired", "none"]


class ScreenSettings(Document):
    """What the clinician asks the patient's screens to show; kept for the session."""

    arrow: StrictBool = False  # to where the chair shall go
    sounds: StrictBool = False
    large: StrictBool = False  # larger text
    plan: StrictBool = False  # the drawn plan from above instead of the 3D view
    language: Annotated[Line, Field(max_length=8)] | None = None  # the patient's; None: that of the screen's browser


def _hash(token: str) -> str:
    return hashlib.sha256(token.encode()).hexdigest()


def add_screen(db: Session, session_id: int, person: str, old_token: str | None) -> str:
    """Pair a screen with the open session, and return its token, which is stored nowhere but with the browser.

    The browser's earlier pairing ends: a page that is paired anew is the same screen.
    """
    session = db.get_one(PatientSession, session_id)
    if session.ended is not None:
        raise Conflict(Text("store-code-over"))
    now = utc_now()
    for old in db.scalars(select(PatientScreen).where(PatientScreen.expires < now)):
        db.delete(old)
    before = db.scalar(select(PatientScreen).where(PatientScreen.token_hash == _hash(old_token or "")))
    if before is not None and before.unpaired is None:
        before.unpaired = now
    db.flush()
    if len(screens_of(db, session_id)) >= MOST:
        raise Conflict(Text("store-screens-most", most=MOST))
    last = db.scalar(select(func.max(PatientScreen.number)).where(PatientScreen.session_id == session_id)) or 0
    token = secrets.token_urlsafe(TOKEN_BYTES)
    screen = PatientScreen(
        clinic_id=session.clinic_id,
        session_id=session_id,
        token_hash=_hash(token),
        number=last + 1,
        paired=now,
        expires=now + PAIRED_FOR,
        unpaired=None,
    )
    db.add(screen)
    db.flush()
    write_log(db, person, "patient's screen paired", screen=screen.id, session=session_id)
    return token


def screens_of(db: Session, session_id: int) -> list[PatientScreen]:
    """Return the screens that are paired with a session, the newest last."""
    return list(
        db.scalars(
            select(PatientScreen)
            .where(
                PatientScreen.session_id == session_id,
                PatientScreen.unpaired.is_(None),
                PatientScreen.expires > utc_now(),
            )
            .order_by(PatientScreen.id)
        )
    )


def find_screen(db: Session, token: str) -> tuple[PatientScreen | None, ScreenState]:
    """Return the screen of a token, None unless it is paired, and its state."""
    row = db.execute(
        select(PatientScreen, PatientSession)
        .join(PatientSession, PatientSession.id == PatientScreen.session_id)
        .where(PatientScreen.token_hash == _hash(token))
    ).first()
    if row is None:
        return None, "none"
    screen, session = row
    if session.ended is not None or screen.expires <= utc_now():
        return None, "over"
    if screen.unpaired is not None:
        return None, "unpaired"
    return screen, "paired"


def unpair_screen(db: Session, screen_id: int, person: str) -> None:
    """End a pairing."""
    missing = Text("store-no-screen", screen=screen_id)
    screen = own_row(db, PatientScreen, screen_id, missing)
    if screen.unpaired is not None:
        raise NotFound(missing)
    screen.unpaired = utc_now()
    write_log(db, person, "patient's screen unpaired", screen=screen.id, session=screen.session_id)


def screen_settings_of(db: Session, session_id: int) -> ScreenSettings:
    """Return the settings of a session's screens; the language is at first that of the patient's session before."""
    session = db.get_one(PatientSession, session_id)
    if session.screen is not None:
        return ScreenSettings.model_validate(session.screen)
    of_patient = select(PatientSession.screen).where(PatientSession.patient_id == session.patient_id)
    sessions = db.scalars(of_patient.order_by(PatientSession.number.desc()))
    before = next((screen for screen in sessions if screen is not None), {})
    return ScreenSettings(language=ScreenSettings.model_validate(before).language)


def set_screen_settings(db: Session, session_id: int, settings: ScreenSettings) -> None:
    """Store the settings of a session's screens."""
    db.get_one(PatientSession, session_id).screen = settings.model_dump(mode="json")
