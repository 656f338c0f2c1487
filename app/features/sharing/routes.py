"""Make, list and revoke the share links of a patient."""

import asyncio
from dataclasses import dataclass
from typing import Annotated

from fastapi import APIRouter, Depends, Request
from fastapi.concurrency import run_in_threadpool
from pydantic import Field

from app.api.answers import Answer, MomentText
from app.api.deps import Clinician, Db, LivePart, RowId, SettingsPart
from app.api.own_address import own_address, reach_hint, setup_hint
from app.api.page_session import OWN_NAME, any_session
from app.api.sign_in.identity import SignedInPerson
from app.api.sign_in.passwords import Passwords
from app.features.sharing.service import (
    MOST_DAYS,
    ShareState,
    add_share,
    find_share,
    last_opened,
    new_pin,
    revoke_share,
    share_state,
    shares_of,
)
from app.news import News
from app.quantities import Document
from app.store.consent import require_consent
from app.store.database import Transaction
from app.store.log import log_viewing, write_log
from app.store.patients import find_patient, find_session

router = APIRouter(tags=["sharing"])

PAGE = "share.html#"  # followed by the token: what stands behind # is never sent to a server


def news_of_shares(patient_id: int) -> News:
    """Return the news that a link of a patient was made, tried, opened or revoked."""
    return News(what="shares", patient=patient_id)


class NewShare(Document):
    """For how many days a link can be opened."""

    days: Annotated[int, Field(strict=True, ge=1, le=MOST_DAYS)] = MOST_DAYS


class ShareRow(Answer):
    """A share link."""

    id: int
    session_id: int | None  # null: all sessions
    person: str  # who made it
    created: MomentText
    expires: MomentText
    state: ShareState
    openings: int
    last_opened: MomentText | None
    wrong_pins: int


class SharesView(Document):
    """The share links of a patient, the newest first."""

    patient_id: int
    shares: list[ShareRow]


class MadeShare(SharesView):
    """A new link and its PIN, shown this once; `message`: where the link does not work."""

    url: str
    pin: str
    message: str


@dataclass(frozen=True)
class NewLinks:
    """Makes share links for a request."""

    request: Request
    passwords: Passwords
    settings: SettingsPart
    database: Db
    live: LivePart

    async def make(
        self, person: SignedInPerson, days: int, *, patient_id: int = 0, session_id: int | None = None
    ) -> MadeShare:
        """Make a link to one session, or to all sessions of a patient."""

        def whose(db: Transaction) -> int:
            of_patient = patient_id if session_id is None else find_session(db, session_id).patient_id
            find_patient(db, of_patient)
            require_consent(db, of_patient, "sharing")
            return of_patient

        def check() -> None:
            with self.database.reading() as db:
                whose(db)

        def store(pin_hash: str) -> MadeShare:
            with self.database.transaction() as db:
                patient = whose(db)
                link, token = add_share(db, patient, session_id, pin_hash, days, person.name)
                details = {"patient": patient, "session": session_id, "share": link.id, "days": days}
                write_log(db, person.name, "share link made", **details)
                hints = (reach_hint(self.settings, address), setup_hint(self.settings))
                return MadeShare(
                    patient_id=patient,
                    shares=_rows(db, patient),
                    url=f"{address.base}{PAGE}{token}",
                    pin=pin,
                    message=" ".join(map(str, filter(None, hints))),
                )

        await run_in_threadpool(check)  # before the PIN is hashed, which takes long
        address = await asyncio.to_thread(own_address, self.settings, self.request)
        pin = new_pin()
        share_link = await run_in_threadpool(store, await self.passwords.hash_of(pin))
        self.live.notify(news_of_shares(share_link.patient_id))
        return share_link


@router.get("/patients/{patient_id}/shares")
def list_shares(patient_id: RowId, person: Clinician, database: Db) -> SharesView:
    """List the share links of a patient.

    For owners and clinicians: with the count and last time of openings (news `shares`; visitors have no names).
    """
    with database.transaction(closing=True) as db:
        find_patient(db, patient_id)
        log_viewing(db, person.name, patient_id)
        return SharesView(patient_id=patient_id, shares=_rows(db, patient_id))


@router.post("/patients/{patient_id}/shares", status_code=201)
@any_session(OWN_NAME)
async def share_course(
    patient_id: RowId,
    body: NewShare,
    person: Clinician,
    links: Annotated[NewLinks, Depends()],
) -> MadeShare:
    """Make a link to all sessions of a patient, who consents to sharing.

    For owners and clinicians. `days` 1 to 14; link and PIN are answered once, with `message` where the link does not
    work.
    """
    return await links.make(person, body.days, patient_id=patient_id)


@router.post("/sessions/{session_id}/shares", status_code=201)
@any_session(OWN_NAME)
async def share_session(
    session_id: RowId,
    body: NewShare,
    person: Clinician,
    links: Annotated[NewLinks, Depends()],
) -> MadeShare:
    """Make a link to one session of a patient, who consents to sharing.

    As for all sessions of a patient.
    """
    return await links.make(person, body.days, session_id=session_id)


@router.delete("/shares/{share_id}")
@any_session(OWN_NAME)
def no_share(share_id: RowId, person: Clinician, database: Db, live: LivePart) -> SharesView:
    """Revoke a share link: nobody reads by it any more."""
    with database.transaction(closing=True) as db:
        link = find_share(db, share_id)
        revoke_share(db, link)
        write_log(db, person.name, "share link revoked", patient=link.patient_id, share=share_id)
        answer = SharesView(patient_id=link.patient_id, shares=_rows(db, link.patient_id))
    live.notify(news_of_shares(answer.patient_id))
    return answer


def _rows(db: Transaction, patient_id: int) -> list[ShareRow]:
    fields = ("id", "session_id", "person", "created", "expires", "openings", "wrong_pins")
    return [
        ShareRow(
            **{name: getattr(link, name) for name in fields},
            state=share_state(link),
            last_opened=last_opened(db, link.id),
        )
        for link in shares_of(db, patient_id)
    ]
