"""The routes that the application serves: their paths, whom they are for, and a request of each."""

import re
from collections.abc import Iterator
from typing import Any

from api.fake_clinic import BASE, Clinic
from fastapi import FastAPI
from fastapi.dependencies.models import Dependant
from fastapi.routing import APIRoute, iter_route_contexts

from app.api.deps import anyone_signed_in, clinician, everyone, exporter, owner, viewer

RIGHTS = {everyone: 0, anyone_signed_in: 1, viewer: 1, clinician: 2, exporter: 2, owner: 3}
CHANGING = {"POST", "PUT", "PATCH", "DELETE"}  # methods of routes that may change something
PLACEHOLDERS = {"name": "nowhere", "step": "rest", "consent": "sharing", "word": "no-such-word"}  # those that are no id
PLACEHOLDERS |= {"kind": "floorplan", "identity": "20260101T000000Z--nowhere"}


def asked(dependant: Dependant) -> Iterator[Any]:
    """Yield the dependencies of a route, at any depth."""
    for below in dependant.dependencies:
        yield below.call
        yield from asked(below)


def needed_query(dependant: Dependant) -> Iterator[str]:
    """Yield the names in the query that a route cannot be asked without."""
    yield from (field.alias for field in dependant.query_params if field.field_info.is_required())
    for below in dependant.dependencies:
        yield from needed_query(below)


def contexts(app: FastAPI, kind: type) -> list[Any]:
    """Return all routes of a kind as they are reached, those of included routers too; each has a path and methods."""
    return [context for context in iter_route_contexts(app.routes) if isinstance(context.original_route, kind)]


def routes_of(clinic: Clinic, methods: set[str]) -> list[str]:
    """Return method and path of every route of the API that has one of these methods."""
    app: Any = clinic.client.app
    return [
        f"{method} {context.path.removeprefix('/api/v1')}"
        for context in contexts(app, APIRoute)
        for method in sorted(context.methods & methods)
    ]


def table(app: FastAPI) -> dict[str, int | None]:
    """Return the highest right that each route requires, None when it requires none."""
    rights = {}
    for context in contexts(app, APIRoute):
        right = max((RIGHTS[call] for call in asked(context.dependant) if call in RIGHTS), default=None)
        for method in context.methods - {"HEAD"}:
            rights[f"{method} {context.path.removeprefix('/api/v1')}"] = right
    return rights


def filled(path: str, **given: Any) -> str:
    """Return a path with something in each placeholder: what is given for it, a word, or the id 1."""
    return re.sub(r"\{(\w+)\}", lambda found: str(given.get(found[1], PLACEHOLDERS.get(found[1], 1))), path)


def requested(clinic: Clinic, name: str, view: str = "clinician") -> Any:
    """Request a route by its method and path as in the table, without content; return the answer."""
    method, path = name.split()
    path = filled(path, role=view)
    is_frame = path == f"/view/{view}/" or path.startswith("/view/replay/")
    prefix = "" if is_frame and method == "GET" else "/api/v1"
    return clinic.client.request(method, f"{prefix}{path}", headers={"Origin": BASE})
