"""Every route that takes an id, in its path, its address or what is sent to it; and a request with such an id."""

import re
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from api.fake_clinic import Clinic
from api.fake_process import LAYOUT

IDS = {  # names of whole numbers that are ids, and of which table
    **dict.fromkeys(("patient_id", "patient", "patients"), "patient"),
    **dict.fromkeys(("trial_id", "trial", "against"), "trial"),
    **dict.fromkeys(("session_id", "other"), "session"),
    **dict.fromkeys(("note_id", "scale_id"), "session"),  # they are those of the session that the path names
    **dict.fromkeys(("chair_id", "PUT /chairs/chosen id"), "chair"),
    "test_id": "interface_test",
    "screen_id": "patient_screen",
    "person_id": "person",
    "incident_id": "incident",
    "comment_id": "moment_comment",
    "share_id": "share_link",
    "layout_id": "clinic_layout",
}
FILLED = {"other": "1", "form": "csv", "reason": "by hand", "dynamics": "unicycle"}
FILLED |= {"floorplan": "apartment", "path": "main"}
LISTS = {"patients"}
OWN_PERSON = 1  # the person who asks, where a path needs an id besides the one that is tried
BODIES: dict[str, dict[str, Any]] = {  # what has to be sent along with an id
    "PUT /interface-tests/{test_id}/workload": {"mental": 5},
    "POST /trials/{trial_id}/discard": {"reason": "x"},
    "PUT /chairs/chosen": {"dynamics": "unicycle"},
    "POST /incidents/{incident_id}/lifting": {"reason": "It is closed"},
    "POST /people": {"name": "Ben", "role": "reviewer"},
    "PUT /people/{person_id}": {"role": "reviewer"},
    "PUT /sessions/{session_id}/goal": {"goal": "x"},
    "POST /sessions/{session_id}/notes": {"text": "x"},
    "PUT /sessions/{session_id}/notes/{note_id}": {"text": "x"},
    "POST /sessions/{session_id}/scales": {"name": "SCIM III", "total": 41.0, "day": "2026-03-01"},
    "POST /sessions/{session_id}/unlock": {"reason": "x"},
    "POST /trials/{trial_id}/comments": {"t": 1.0, "text": "x"},
    "POST /trials/{trial_id}/comments/read": {},
    "PUT /comments/{comment_id}": {"text": "x"},
    "POST /patients/{patient_id}/shares": {"days": 14},
    "POST /sessions/{session_id}/shares": {"days": 14},
    "PUT /patients/{patient_id}/consents/{consent}": {"given": "2026-03-01"},
    "PUT /layouts/{layout_id}": {"version": 1, "layout": LAYOUT.model_dump(mode="json")},
}
MISSING = 2**31 - 1  # an id that nothing has


class Place(NamedTuple):
    """A whole number that a route takes, and the names of everything else that has to be sent along."""

    method: str
    path: str  # behind /api/v1
    name: str
    needed: list[str]

    @property
    def route(self) -> str:
        """The method and the path."""
        return f"{self.method} {self.path}"

    @property
    def table(self) -> str | None:
        """The table whose id the number is; None for a number that is no id."""
        return IDS.get(f"{self.route} {self.name}") or IDS.get(self.name)

    @property
    def is_in_path(self) -> bool:
        """Whether the number stands in the path."""
        return f"{{{self.name}}}" in self.path

    def asked(self, clinic: Clinic, ids: int | Mapping[str, int], **more_body: Any) -> Any:
        """Return the answer to a request with `ids`, by their names, or with one number for all ids of a patient."""

        def given(name: str) -> int | None:
            if isinstance(ids, Mapping):
                return ids.get(name)
            if name == self.name or (name.endswith("_id") and name != "person_id"):
                return ids
            return OWN_PERSON if name == "person_id" else None

        def filled(placeholder: re.Match[str]) -> str:
            number = given(placeholder[1])
            return placeholder[0] if number is None else str(number)

        url = re.sub(r"\{(\w+)\}", filled, self.path).replace("{consent}", "sharing")
        more = {other: FILLED[other] for other in self.needed if other != self.name}
        body = BODIES.get(self.route)
        number = given(self.name)
        if not self.is_in_path and self.method == "GET":
            more[self.name] = str(number)
        elif not self.is_in_path:
            body = (body or {}) | {self.name: [number] if self.name in LISTS else number}
        if more_body:
            body = (body or {}) | more_body
        return clinic(self.method, url, params=more, json=body)


def integers(document: dict[str, Any], schema: dict[str, Any], name: str = "") -> Iterator[str]:
    """Yield the names of all whole numbers in a schema, at any depth."""
    if "$ref" in schema:
        yield from integers(document, document["components"]["schemas"][schema["$ref"].rsplit("/", 1)[1]], name)
    if schema.get("type") == "integer":
        yield name
    for key in ("anyOf", "oneOf", "allOf", "prefixItems"):
        for inner in schema.get(key, []):
            yield from integers(document, inner, name)
    for inner in (schema.get("items"), schema.get("additionalProperties")):
        if isinstance(inner, dict):
            yield from integers(document, inner, name)
    for inner_name, inner in schema.get("properties", {}).items():
        yield from integers(document, inner, inner_name)


def places(document: dict[str, Any]) -> Iterator[Place]:
    """Yield every whole number that the routes of an OpenAPI document take."""
    for address, methods in document["paths"].items():
        path = address.removeprefix("/api/v1")
        for method, operation in methods.items():
            given = operation.get("parameters", [])
            needed = [parameter["name"] for parameter in given if parameter["in"] == "query" and parameter["required"]]
            for parameter in given:
                for name in integers(document, parameter["schema"], parameter["name"]):
                    yield Place(method.upper(), path, name, needed)
            content = operation.get("requestBody", {}).get("content", {}).get("application/json", {})
            for name in integers(document, content.get("schema", {})):
                yield Place(method.upper(), path, name, needed)
