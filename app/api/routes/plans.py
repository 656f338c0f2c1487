"""The clinic's own floor plans: checked while they are drawn, saved, deleted, and made from files."""

import asyncio
from typing import Annotated, Any

from fastapi import APIRouter, Form, HTTPException, Query, Request, UploadFile
from pydantic import ValidationError

from app.api.answers import Answer
from app.api.deps import Clinician, Db, OwnPlansPart, ReadingsPart, ReplacedFilesPart
from app.api.page_session import OF_CLINIC, any_session
from app.api.routes.plan_uploads import draft_of_uploads
from app.quantities import Document, Name
from app.sentences import one_sentence
from app.store.database import Database
from app.store.files.name_conflicts import SameName, log_details
from app.store.log import write_log
from app.texts import Text
from app.world.floorplan import ClearanceError, FloorPlan

WHERE = Text("api-the-plan")
MOST_PARTS = 250_000  # lists and objects of a document: far more than a building needs

router = APIRouter(tags=["floor plans"])


class OwnPlanView(Answer):
    """A floor plan of the clinic's own; a change is refused unless it names this `version`."""

    name: str
    title: str
    version: int


class CheckView(Document):
    """Whether a floor plan is valid; if not, why, and where in the document and on the floor."""

    good: bool
    sentence: Text | str
    place: list[int | str]
    at: tuple[float, float] | None  # m


class DraftView(Document):
    """A floor plan made from a file, not saved: the document, notes on it, a drawing's layers, and its wall layers."""

    document: dict[str, Any]
    messages: list[str]
    layers: list[str]
    taken: list[str]


def _too_many(content: bytes) -> Text | None:
    """Return why a document is too large to be parsed, which would block other requests; None when it is not."""
    if content.count(b"[") + content.count(b"{") > MOST_PARTS:
        return Text("api-plan-too-many-parts", count=MOST_PARTS)
    return None


def _parsed(content: bytes) -> FloorPlan:
    """Return the floor plan of a request's body; 422 with the place in the document."""
    if message := _too_many(content):
        raise HTTPException(422, message)
    try:
        return FloorPlan.model_validate_json(content)
    except ValidationError as error:
        raise HTTPException(422, Text("api-problem", problem=one_sentence(error, WHERE))) from error


def _checked(content: bytes) -> CheckView:
    if message := _too_many(content):
        return CheckView(good=False, sentence=message, place=[], at=None)
    try:
        FloorPlan.model_validate_json(content)
    except ValidationError as error:
        first = error.errors(include_url=False)[0]
        cause = first.get("ctx", {}).get("error")
        return CheckView(
            good=False,
            sentence=Text("api-problem", problem=one_sentence(error, WHERE)),
            place=list(first["loc"]),
            at=(cause.x, cause.y) if isinstance(cause, ClearanceError) else None,
        )
    return CheckView(good=True, sentence="", place=[], at=None)


def _log(database: Database, person: str, what: str, **details: Any) -> None:
    with database.transaction() as db:
        write_log(db, person, what, **details)


@router.get("/own-floorplans")
def list_own(_person: Clinician, own_plans: OwnPlansPart) -> list[OwnPlanView]:
    """List the clinic's own floor plans."""
    return [OwnPlanView.of(plan) for plan in own_plans.listed()]


@router.post("/floorplans/check")
@any_session(OF_CLINIC)
async def check(request: Request, _person: Clinician) -> CheckView:
    """Check whether a document is a valid floor plan; save nothing.

    `place`: keys and indices of what is wrong.
    """
    # In a thread: a large plan takes long to check, and the event loop must stay free for other requests.
    return await asyncio.to_thread(_checked, await request.body())


@router.post("/floorplans/import")
@any_session(OF_CLINIC)
async def import_files(
    files: list[UploadFile],
    _person: Clinician,
    readings: ReadingsPart,
    options: Annotated[str, Form(max_length=100_000)] = "{}",
) -> DraftView:
    """Propose a floor plan made of a DXF drawing, a picture, or a ROS map (its YAML file and its picture).

    `options` is a JSON object: unit, layers, metres_per_pixel, width, threshold, outside, title, name.

    The multipart field `files`: one .dxf, .png or .jpg, or a map's .yaml with its picture; 20 MB each. Nothing is
    saved, and the document may have no path yet.
    """
    return DraftView(**await draft_of_uploads(files, options, readings))


@router.post("/floorplans", status_code=201)
@any_session(OF_CLINIC)
async def save_new(
    request: Request,
    person: Clinician,
    database: Db,
    replaced: ReplacedFilesPart,
    own_plans: OwnPlansPart,
    same_name: SameName = "ask",
) -> OwnPlanView:
    """Save a document as a new floor plan of the clinic; `same_name`: what to do when its name is taken."""
    content = await request.body()

    def save() -> OwnPlanView:
        saved = own_plans.add(_parsed(content), same_name, replaced)
        _log(
            database,
            person.name,
            "floor plan saved",
            floorplan=saved.name,
            version=saved.version,
            **log_details(same_name),
        )
        return OwnPlanView.of(saved)

    return await asyncio.to_thread(save)


@router.put("/floorplans/{name}")
@any_session(OF_CLINIC)
async def save_version(
    name: Name,
    version: Annotated[int, Query(ge=1, le=2**31)],
    request: Request,
    person: Clinician,
    database: Db,
    own_plans: OwnPlansPart,
) -> OwnPlanView:
    """Save the next version of a floor plan; refused when somebody saved it after `version` was read.

    409 for the name of a bundled plan. All versions stay in `floorplans/versions/NAME/`.
    """
    content = await request.body()

    def save() -> OwnPlanView:
        plan = _parsed(content)
        if plan.name != name:
            raise HTTPException(422, Text("api-plan-other-name", name=name))
        now = own_plans.replace(plan, version)
        _log(database, person.name, "floor plan saved", floorplan=name, version=now)
        return OwnPlanView(name=name, title=plan.title, version=now)

    return await asyncio.to_thread(save)


@router.delete("/floorplans/{name}")
@any_session(OF_CLINIC)
def delete(name: Name, person: Clinician, database: Db, own_plans: OwnPlansPart) -> list[OwnPlanView]:
    """Take a floor plan out of what is offered; it can be restored."""
    own_plans.remove(name)
    _log(database, person.name, "floor plan deleted", floorplan=name)
    return list_own(person, own_plans)


@router.post("/floorplans/{name}/restore")
@any_session(OF_CLINIC)
def restore(name: Name, person: Clinician, database: Db, own_plans: OwnPlansPart) -> list[OwnPlanView]:
    """Offer a deleted floor plan again."""
    version = own_plans.restore(name)
    _log(database, person.name, "floor plan restored", floorplan=name, version=version)
    return list_own(person, own_plans)
