"""The check of the log against changes, for owners."""

from fastapi import APIRouter

from app.api.answers import Answer
from app.api.deps import Owner, PeopleParts
from app.store.log_chain import verify_log

router = APIRouter(prefix="/log", tags=["log"])


class LogCheckView(Answer):
    """The result of a check of the log."""

    whole: bool
    rows: int
    words: str


@router.get("/check")
def check_log(_who: Owner, parts: PeopleParts) -> LogCheckView:
    """Check every row of the log, and its newest rows against its head."""
    return LogCheckView.of(verify_log(parts.settings.database))
