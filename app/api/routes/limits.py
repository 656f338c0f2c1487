"""The clinic's speed limits, set by an owner."""

from fastapi import APIRouter

from app.api.deps import Anyone, LimitsPart, Owner
from app.api.page_session import OF_CLINIC, any_session
from app.speed_limits import Speeds

router = APIRouter(prefix="/limits", tags=["limits"])


@router.get("")
async def read_limits(_person: Anyone, clinic_limits: LimitsPart) -> Speeds:
    """Return the clinic's limits."""
    return clinic_limits.speeds


@router.put("")
@any_session(OF_CLINIC)
async def set_limits(body: Speeds, person: Owner, clinic_limits: LimitsPart) -> Speeds:
    """Set the clinic's limits: lower ones hold at once, higher ones only while the chair stands.

    For owners. A set above the limits keeps its numbers and drives at the smaller ones.
    """
    await clinic_limits.set(body, person.name)
    return clinic_limits.speeds
