"""The log, for owners: its rows, an export with its chain, and the check against changes."""

from typing import Annotated, Any, Literal

from fastapi import APIRouter, Query
from fastapi.responses import StreamingResponse
from pydantic import Field

from app.api.answers import Answer, MomentText
from app.api.deps import Db, Owner, SettingsPart
from app.clock import utc_now
from app.download_name import download_name
from app.features.log.service import exported_lines, people_in_log, read_log
from app.quantities import Document
from app.store.log import write_log
from app.store.log_chain import verify_log
from app.store.patients import find_patient
from app.texts import Text

router = APIRouter(prefix="/log", tags=["log"])

PAGE = 100  # rows
MEDIA_TYPES = {"csv": "text/csv; charset=utf-8", "jsonl": "application/x-ndjson"}

RowNumber = Annotated[int, Field(ge=1, le=2**53)]


class LogCheckView(Answer):
    """The result of a check of the log."""

    whole: bool
    rows: int
    message: Text


class LogEntryView(Answer):
    """A row of the log."""

    id: int
    at: MomentText
    person: str | None
    what: str
    details: dict[str, Any]


class LogView(Document):
    """Some rows, the newest first; `people`: everybody who is named in the log."""

    entries: list[LogEntryView]
    has_more: bool
    people: list[str]


@router.get("")
def read_log_page(
    _owner: Owner,
    database: Db,
    person: Annotated[str | None, Query(max_length=80)] = None,
    patient: Annotated[int | None, Query(ge=1, le=2**31)] = None,
    before: Annotated[RowNumber | None, Query()] = None,
) -> LogView:
    """Return rows of the log: of a person, of a patient, older than the row `before`.

    For owners: the newest 100 first. A row belongs to a patient when it names the patient, or a session, trial, drive
    or screen of the patient.
    """
    with database.reading() as db:
        if patient is not None:
            find_patient(db, patient, deleted=True)
        entries = read_log(db, PAGE + 1, person=person, patient=patient, before=before)
        return LogView(
            entries=[LogEntryView.of(entry) for entry in entries[:PAGE]],
            has_more=len(entries) > PAGE,
            people=people_in_log(db),
        )


@router.get("/export", response_class=StreamingResponse)
def export(form: Literal["csv", "jsonl"], person: Owner, database: Db) -> StreamingResponse:
    """Return the whole log as a file: CSV for a spreadsheet, or JSON lines, from which the chain can be computed.

    For owners: all rows with their hashes, oldest first.
    """
    with database.transaction(closing=True) as db:
        write_log(db, person.name, "log exported", form=form)
    name = download_name("log", utc_now(), form)
    lines = exported_lines(database, as_csv=form == "csv")
    headers = {"Content-Disposition": f'attachment; filename="{name}"'}
    return StreamingResponse(lines, media_type=MEDIA_TYPES[form], headers=headers)


@router.get("/check")
def check_log(_owner: Owner, settings: SettingsPart) -> LogCheckView:
    """Check every row of the log, and its newest rows against its head."""
    return LogCheckView.of(verify_log(settings.database))
