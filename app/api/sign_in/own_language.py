"""The reader's language: chosen on a page, kept in a cookie of the browser and with the person who is signed in."""

from typing import Annotated

from fastapi import APIRouter, HTTPException, Request, Response
from pydantic import Field

from app.api.deps import Db, ForEveryone
from app.api.page_session import LOOKS, any_session
from app.api.request_language import keep_language
from app.api.who_asks import WhoAsks
from app.quantities import Document, Line
from app.store.access.rights import find_person_by_id
from app.texts import LANGUAGES, Text

router = APIRouter(prefix="/auth", tags=["sign-in"], dependencies=[ForEveryone])


class LanguageChoice(Document):
    """The language that a reader wants."""

    language: Annotated[Line, Field(max_length=8)]  # ISO 639-1, of those that are offered


@router.put("/language", status_code=204)
@any_session(LOOKS)
def choose_language(body: LanguageChoice, request: Request, response: Response, person: WhoAsks, database: Db) -> None:
    """Choose the language of this browser's pages, and of the person's who is signed in on it."""
    if body.language not in LANGUAGES:
        raise HTTPException(422, Text("language-not-offered", language=body.language, languages=LANGUAGES))
    keep_language(request, response, body.language)
    if person is not None:
        with database.transaction() as db:
            find_person_by_id(db, person.person_id).language = body.language
