"""Every text that a person can send must be visible; the fields are found in the routes, not listed."""

import json
import random
import types
from collections.abc import Iterator
from contextlib import suppress
from typing import Annotated, Any, Union, get_args, get_origin

import pytest
from api.plan_documents import plan
from fastapi.routing import APIRoute
from pydantic import BaseModel, TypeAdapter, ValidationError

from app.api.app import ROUTES
from app.layout import ShirtLayout
from app.world.floorplan import FloorPlan
from app.world.imports.options import Options

MARKS = (0x200E, 0x200F, 0x061C, 0x200B, 0x200C, 0x200D, 0x2060, 0xFEFF, 0x2028, 0x2029)
OVERRIDES = (*range(0x202A, 0x202F), *range(0x2066, 0x206A))
UNSEEN = [*"\0\a\x1b\x7f\x85", *map(chr, (*MARKS, *OVERRIDES))]
# Read from the body of a request or from a form, so that no route names them.
DOCUMENTS = [FloorPlan, Options, ShirtLayout]
JSON = {"Content-Type": "application/json"}
SECRET = {"password", "old", "new", "code"}  # never shown: a password may hold anything
LOOKED_UP = {"file", "device"}  # what a machine's file or device is called; it is found or not


def texts(annotation: Any, metadata: tuple[Any, ...], where: str) -> Iterator[tuple[str, Any]]:
    """Yield every text in an annotation with its constraints and its place."""
    origin = get_origin(annotation)
    if origin is Annotated:
        inner, *more = get_args(annotation)
        yield from texts(inner, (*more, *metadata), where)
    elif annotation is str:
        yield where, Annotated[(str, *metadata)] if metadata else str
    elif origin in {Union, types.UnionType, list, tuple, dict, set, frozenset}:
        for inner in get_args(annotation):
            yield from texts(inner, (), where)
    elif isinstance(annotation, type) and issubclass(annotation, BaseModel):
        for name, field in annotation.model_fields.items():
            if name not in SECRET | LOOKED_UP:
                yield from texts(field.annotation, tuple(field.metadata), f"{annotation.__name__}.{name}")


def bodies() -> list[Any]:
    found: list[Any] = [*DOCUMENTS]
    for module in ROUTES:
        for route in module.router.routes:
            if isinstance(route, APIRoute) and route.body_field is not None:
                found += [given.field_info.annotation for given in route.dependant.body_params]
    return [one for one in found if one is not str]  # the import's options are a text: a document of its own


FIELDS = dict(found for body in bodies() for found in texts(body, (), "body"))


def test_the_fields_are_found() -> None:
    assert {"NewPatient.pseudonym", "NewPatient.note", "FirstOwner.name", "FloorPlan.title"} <= FIELDS.keys()
    assert len(FIELDS) > 30


def test_no_text_takes_what_nobody_sees() -> None:
    taken = []
    for place, kind in FIELDS.items():
        field = TypeAdapter(kind)
        for character in UNSEEN:
            for text in (f"ab{character}cdefgh", character, f"abcdefgh{character}"):
                with suppress(ValidationError):
                    taken.append((place, field.validate_python(text)))
    assert taken == []


@pytest.mark.parametrize(
    ("path", "document", "words"),
    [
        ("/patients", {"code": "P-1", "pseudonym": "He\u202eron"}, "pseudonym: character 3 is U+202E"),
        ("/patients", {"code": "P-1", "pseudonym": "\0"}, "pseudonym: character 1 is U+0000 (a control character)"),
        ("/patients", {"code": "P-1", "pseudonym": "Heron", "note": "one\ntwo\u2066"}, "note: character 8 is U+2066"),
    ],
)
def test_the_sentence_says_which_character_where(signed_in: Any, path: str, document: Any, words: str) -> None:
    sentence = signed_in.refused(422, "POST", path, json=document)
    assert words in sentence
    assert sentence.isprintable()


def odd_values() -> list[str]:
    """Return 200 texts as sent by a form, a phone or an attacker."""
    dice = random.Random(11)
    signs = "\ud800\udfff\ufffd\uffff=+-@'\"<>&\\/%;|`$ \t\n\U0001f642\u05d0\u0645\u6f22a"
    kinds = [*UNSEEN, *signs, "e\u0301"]
    mixed = ["".join(dice.choices(kinds, k=dice.randint(1, 90))) for _ in range(150)]
    plain = ["", " ", "\n", "a" * 80, "a" * 81, "a" * 5000, "../../x", "NUL", "null", "NaN", "<script>", "'; --", "%00"]
    return (plain + kinds + mixed)[:200]


def test_odd_values_are_refused_with_a_sentence_or_kept_exactly(signed_in: Any) -> None:
    signed_in.begin_session()
    kept = 0
    values = odd_values()
    assert len(values) == 200
    for number, text in enumerate(values):
        for field in ("code", "pseudonym", "note"):
            given = {"code": f"Q-{number}-{field}", "pseudonym": "Heron", "note": "", field: text}
            kept += kept_or_refused(signed_in, "/patients", given, field)
        for field in ("name", "title"):
            document = plan(f"plan-{number}-{field}") | {field: text}
            kept += kept_or_refused(signed_in, "/floorplans", document, field)
        given = {"name": text, "password": "a password of the tests"}
        answer = signed_in("POST", "/auth/sign-in", content=sent(given), headers=JSON)
        assert answer.status_code in {401, 409, 422, 429}
        assert isinstance(answer.json()["detail"], str)
    assert kept > 50


def kept_or_refused(clinic: Any, path: str, given: dict[str, Any], field: str) -> bool:
    answer = clinic("POST", path, content=sent(given), headers=JSON)
    if answer.status_code == 201:
        assert answer.json()[field] == given[field]
        return True
    assert answer.status_code in {409, 422}, answer.text
    assert answer.json()["detail"].endswith(".")
    assert answer.json()["detail"].isprintable()
    return False


def sent(document: Any) -> bytes:
    return json.dumps(document).encode()
