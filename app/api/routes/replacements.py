"""Replaced files: listed for 30 days, and restored under a free name."""

import asyncio
from typing import Annotated

from fastapi import APIRouter, HTTPException, Path
from pydantic import ValidationError

from app.api.answers import Answer, MomentText
from app.api.deps import Clinician, Db, OwnPlansPart, ReplacedFilesPart
from app.api.page_session import OF_CLINIC, any_session
from app.quantities import Document
from app.store.files.plans import OwnPlans
from app.store.files.replacements import Kind, ReplacedFiles
from app.store.log import write_log
from app.texts import Text
from app.world.floorplan import FloorPlan

router = APIRouter(prefix="/replaced", tags=["uploads"])

Identity = Annotated[str, Path(max_length=160, pattern=r"^[0-9TZ.]+--[A-Za-z0-9_.-]+$")]


class ReplacedView(Answer):
    """A replaced file; at `until` it is deleted."""

    kind: Kind
    id: str
    name: str
    bytes: int
    replaced: MomentText
    until: MomentText


class RestoredView(Document):
    """The name of a restored file."""

    kind: Kind
    name: str


@router.get("")
def list_replaced(_person: Clinician, replaced: ReplacedFilesPart) -> list[ReplacedView]:
    """List what was replaced in the last 30 days, newest first."""
    return [ReplacedView.of(file) for file in replaced.listed()]


@router.post("/{kind}/{identity}/restore")
@any_session(OF_CLINIC)
async def restore(
    kind: Kind,
    identity: Identity,
    person: Clinician,
    database: Db,
    replaced: ReplacedFilesPart,
    own_plans: OwnPlansPart,
) -> RestoredView:
    """Restore a replaced file, under a free name when its own is taken."""

    def put_back() -> RestoredView:
        name = (
            _restored_plan(replaced, own_plans, identity) if kind == "floorplan" else replaced.restore(kind, identity)
        )
        with database.transaction() as db:
            write_log(db, person.name, "replaced file restored", kind=kind)
        return RestoredView(kind=kind, name=name)

    return await asyncio.to_thread(put_back)


def _restored_plan(replaced: ReplacedFiles, own_plans: OwnPlans, identity: str) -> str:
    """Save a replaced floor plan again, under the name in its document."""
    file, content = replaced.content("floorplan", identity)
    try:
        plan = FloorPlan.model_validate_json(content)
    except ValidationError as error:
        raise HTTPException(409, Text("api-plan-unreadable")) from error
    saved = own_plans.add(plan, "keep-both", replaced)
    replaced.discard(file)
    return saved.name
