"""The OpenAPI document of all routes; for owners only, because it would help an attacker."""

from typing import Any

from fastapi import APIRouter, Request

from app.api.deps import Owner

router = APIRouter()


@router.get("/openapi.json", include_in_schema=False)
def describe(_who: Owner, request: Request) -> dict[str, Any]:
    """Return the OpenAPI document."""
    document: dict[str, Any] = request.app.openapi()
    return document
