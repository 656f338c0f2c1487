"""The clinic's speed limits, set by an owner."""

from fastapi import APIRouter

from app.api.deps import Anyone, Owner
from app.api.parts import Web
from app.speeds import Speeds

router = APIRouter(prefix="/limits", tags=["limits"])


@router.get("")
async def look(_who: Anyone, web: Web) -> Speeds:
    """Return the clinic's limits."""
    return web.limits.speeds


@router.put("")
async def set_limits(body: Speeds, who: Owner, web: Web) -> Speeds:
    """Set the clinic's limits: lower ones hold at once, higher ones only while the chair stands.

    For owners. A set above the limits keeps its numbers and drives at the smaller ones.
    """
    await web.limits.set(body, who.name)
    return web.limits.speeds
