"""Turn every exception into an answer `{"detail": sentence}` without a traceback, in the reader's language."""

import errno
import logging
from typing import Any, Final, Literal, cast

from fastapi import FastAPI, Request
from fastapi.concurrency import run_in_threadpool
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse
from pydantic_core import ErrorDetails
from starlette.exceptions import HTTPException

from app.api.parts import parts_of
from app.api.request_language import language_of
from app.api.sign_in.identity import find_sign_in
from app.quantities import Document
from app.refusals import NO_ROOM, Conflict, DiskFull, NotFound, OtherClinicRow, PatientHere, Refusal, Unavailable
from app.scene.models.object_scale import ScaleAsked
from app.sentences import sentence_of
from app.store.database import Database
from app.store.files.name_conflicts import NameTaken
from app.store.log import write_log
from app.texts import Text, reader_language

STATUS: dict[type[Exception], int] = {
    NotFound: 404,
    OtherClinicRow: 404,
    Conflict: 409,
    Unavailable: 503,
    DiskFull: 507,
}


class NameChoice(Document):
    """What can be done about a name that is taken."""

    proposed: str  # a free name
    may_replace: bool


class ObjectScale(Document):
    """A length that one unit of a 3D object may have, and the object's size with it."""

    metres_per_unit: float
    size: tuple[float, float, float]  # m: length, width, height


class ObjectScales(Document):
    """The lengths that one unit of a 3D object may have whose size is improbable in metres."""

    scales: list[ObjectScale]


class PatientChoice(Document):
    """What can be done about a patient of an archive who is in the clinic already."""

    may_replace_patient: Literal[True] = True


class Refused(Document):
    """Every answer that is no success: one sentence, and a choice.

    A person chooses where a name is taken, where a size is improbable, and where a patient is here already.
    """

    detail: str
    choice: NameChoice | ObjectScales | PatientChoice | None = None


REFUSALS: Final[dict[int | str, dict[str, Any]]] = {
    "4XX": {"model": Refused, "description": "Refused, with what is wrong and what to do"},
    "5XX": {"model": Refused, "description": "Something is out of reach, or went wrong inside the program"},
}
"""The answers of every route that FastAPI does not know of; the handlers below write them."""

WHERE: Final = {
    "body": Text("refused-in-body"),
    "query": Text("refused-in-address"),
    "path": Text("refused-in-address"),
    "header": Text("refused-in-header"),
}
BY_FRAMEWORK: Final = {404: Text("refused-no-address"), 405: Text("refused-no-method")}


def _answer(status: int, text: Text | str) -> JSONResponse:
    sentence = str(text)
    whole = sentence[:1].upper() + sentence[1:].removesuffix(".") + "."
    return JSONResponse({"detail": whole}, status)


async def _broken(request: Request, error: Exception) -> JSONResponse:
    with reader_language(language_of(request)):  # this handler stands outside of the middleware
        if isinstance(error, OSError) and error.errno == errno.ENOSPC:
            return _answer(507, NO_ROOM)
        logging.getLogger("bodydrive").error("%s %s failed", request.method, request.url.path, exc_info=error)
        return _answer(500, Text("refused-broken"))


def _note(request: Request, error: OtherClinicRow) -> None:
    """Log who requested a row of another clinic; the answer does not depend on it."""
    database = parts_of(request.app)[Database]
    try:
        person = find_sign_in(database, request)
        with database.transaction() as db:
            write_log(db, person.name if person else None, "another clinic's id", **{error.kind: error.row_id})
    except Refusal:
        logging.getLogger("bodydrive").exception("A request for another clinic's %s could not be noted", error.kind)


def install_refusals(app: FastAPI) -> None:
    """Install the handlers that turn exceptions into sentences."""

    @app.exception_handler(NameTaken)
    async def _taken(_request: Request, error: NameTaken) -> JSONResponse:
        choice = {"proposed": error.proposed, "may_replace": error.may_replace}
        return JSONResponse({"detail": str(error), "choice": choice}, 409)

    @app.exception_handler(ScaleAsked)
    async def _asked(_request: Request, error: ScaleAsked) -> JSONResponse:
        scales = [{"metres_per_unit": scale, "size": size} for scale, size in error.scales.items()]
        return JSONResponse({"detail": str(error), "choice": {"scales": scales}}, 422)

    @app.exception_handler(PatientHere)
    async def _here(_request: Request, error: PatientHere) -> JSONResponse:
        return JSONResponse({"detail": str(error), "choice": {"may_replace_patient": True}}, 409)

    @app.exception_handler(Refusal)
    async def _refused(request: Request, error: Refusal) -> JSONResponse:
        if isinstance(error, OtherClinicRow):
            await run_in_threadpool(_note, request, error)
        return _answer(STATUS.get(type(error), 409), str(error))

    @app.exception_handler(HTTPException)
    async def _http(_request: Request, error: HTTPException) -> JSONResponse:
        if error.status_code == 400:  # raised by the framework only, for a body that it cannot parse
            return _answer(422, Text("refused-unreadable"))
        plain = error.detail in {"Not Found", "Method Not Allowed"}
        sentence = BY_FRAMEWORK.get(error.status_code, error.detail) if plain else error.detail
        return JSONResponse({"detail": str(sentence)}, error.status_code, headers=error.headers)

    @app.exception_handler(RequestValidationError)
    async def _invalid(_request: Request, error: RequestValidationError) -> JSONResponse:
        first = error.errors()[0]
        if first["type"] == "json_invalid":
            return _answer(422, Text("refused-not-json"))
        if isinstance(error.body, bytes) and first["loc"] == ("body",):
            return _answer(415, Text("refused-not-declared"))
        if first["type"] == "value_error" and "UploadFile" in first["msg"]:
            return _answer(422, Text("refused-no-file"))
        problems = cast(
            "list[ErrorDetails]", [{**problem, "loc": tuple(problem["loc"])[1:]} for problem in error.errors()]
        )
        return _answer(422, sentence_of(problems, WHERE.get(str(first["loc"][0]), WHERE["body"])))

    app.add_exception_handler(Exception, _broken)
