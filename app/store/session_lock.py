"""Whether anything of a session may still be changed: a feature may lock a session that was signed off."""

from sqlalchemy.orm import Session

from app.features.registration import features
from app.refusals import Conflict


def why_locked(db: Session, session_id: int) -> str:
    """Return the sentence why nothing of a session may be changed; empty when it may."""
    return next(filter(None, (one.why_locked(db, session_id) for one in features().values())), "")


def require_unlocked(db: Session, session_id: int) -> None:
    """Raise Conflict when a session is locked: for functions that may also find that nothing changes."""
    if words := why_locked(db, session_id):
        raise Conflict(words)
