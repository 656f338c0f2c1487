"""The sentences for a person's first time: put away once, on whatever screen, they never come again."""

from fastapi import APIRouter

from app.api.deps import Anyone, Db
from app.api.page_session import LOOKS, any_session
from app.store.access.rights import find_person_by_id

router = APIRouter(prefix="/auth", tags=["sign-in"])


@router.post("/introduction", status_code=204)
@any_session(LOOKS)
def put_away(person: Anyone, database: Db) -> None:
    """Store that the person who is signed in has read or skipped the sentences."""
    with database.transaction() as db:
        find_person_by_id(db, person.person_id).introduced = True
