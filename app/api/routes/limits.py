"""What the clinic's owner allows."""

from fastapi import APIRouter

from app.api.deps import Anyone, Owner
from app.api.parts import FlowParts
from app.speeds import Speeds

router = APIRouter(prefix="/limits", tags=["limits"])


@router.get("")
async def look(_who: Anyone, flows: FlowParts) -> Speeds:
    """Return the clinic's limits."""
    return flows.limits.speeds


@router.put("")
async def set_limits(body: Speeds, who: Owner, flows: FlowParts) -> Speeds:
    """Set the clinic's limits: lower ones hold at once, higher ones only while the chair stands."""
    await flows.limits.set(body, who.name)
    return flows.limits.speeds
