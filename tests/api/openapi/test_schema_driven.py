"""Requests that are made from the OpenAPI document: none breaks the server, and each answer fits its schema."""

import json
import random
from collections import Counter
from collections.abc import Iterator
from typing import Any
from urllib.parse import quote

import pytest
from api.fake_clinic import BASE, Clinic
from api.openapi.json_schema import misfits, value_for

SLOW = {"/api/v1/computer/measurement"}  # it measures for as many seconds as it is asked to
ODD = (0.0, 0.05, 0.3)  # probabilities that a part of a request is something else


def operations(document: dict[str, Any]) -> Iterator[tuple[str, str, dict[str, Any]]]:
    for path, methods in document["paths"].items():
        for method, operation in methods.items():
            if path not in SLOW:
                yield path, method.upper(), operation


def request_of(path: str, operation: dict[str, Any], document: dict[str, Any], dice: random.Random) -> dict[str, Any]:
    """Return the address and what else is sent."""
    odd = dice.choice(ODD)
    sent: dict[str, Any] = {"params": {}, "headers": {}}
    for parameter in operation.get("parameters", ()):
        value = value_for(parameter["schema"], document, dice, odd)
        if parameter["in"] == "path":
            value = dice.choice((1, 1, 2, value)) if parameter["schema"].get("type") == "integer" else value
            word = quote(str(value).encode("utf-8", "replace"), safe="") or "x"
            path = path.replace(f"{{{parameter['name']}}}", word)
        elif parameter["in"] == "query" and (parameter.get("required") or dice.random() < 0.5):
            sent["params"][parameter["name"]] = str(value).encode("utf-8", "replace").decode()
    body = operation.get("requestBody", {}).get("content", {})
    if "application/json" in body:
        content = json.dumps(value_for(body["application/json"]["schema"], document, dice, odd))
        content = dice.choice((content,) * 9 + (content[:-1],))
        sent |= {"content": content, "headers": {"Content-Type": "application/json"}}
    elif "multipart/form-data" in body:
        sent["files"] = {"file": (dice.choice(("walk.csv", "a.glb", "plan.dxf", "x")), b"t,a\n0,1\n")}
    elif body:
        sent["content"] = b"PK" + dice.randbytes(40)
    return {"path": path, **sent}


def wrong_answer(operation: dict[str, Any], answer: Any, document: dict[str, Any]) -> list[str]:
    """Return what an answer has that its operation does not declare."""
    code = str(answer.status_code)
    declared = operation["responses"]
    known = declared.get(code) or declared.get(f"{code[0]}XX")
    if known is None:
        return [f"{code} is not declared"]
    kind = answer.headers.get("content-type", "").partition(";")[0]
    content: dict[str, dict[str, Any]] = known.get("content", {})
    if not content:  # nothing, or a file, whose content the document does not describe
        undeclared = kind == "application/json" and answer.content
        return [f"{code} has a JSON content, and none is declared"] if undeclared else []
    if kind != "application/json":
        schema = next(iter(content.values()), {}).get("schema", {})
        fits = not answer.content or schema == {} or kind in content
        return [] if fits else [f"{code} is {kind}, declared: {content}"]
    schema = content.get("application/json", {}).get("schema", {})
    try:
        value = answer.json()
    except ValueError:
        return [f"{code} is no JSON: {answer.content[:40]!r}"]
    return [f"{code}{each}" for each in misfits(schema, value, document)]


def failures(clinic: Clinic, role: str, count: int, seed: int) -> tuple[list[str], Counter[int]]:
    """Send so many requests as a person of this role; return what is wrong, and how often each status came."""
    document: dict[str, Any] = clinic.client.app.openapi()  # type: ignore[attr-defined]
    every = list(operations(document))
    dice = random.Random(seed)
    wrong: list[str] = []
    codes: Counter[int] = Counter()
    for number in range(count):
        path, method, operation = every[number % len(every)] if number < len(every) else dice.choice(every)
        clinic.client.cookies.update(clinic.cookies_of(f"{role} {number // 50}", role))  # anew: a request may end it
        sent = request_of(path, operation, document, dice)
        headers = {"Origin": BASE, "Patient-Session": clinic.session, **sent.pop("headers")}
        answer = clinic.client.request(method, sent.pop("path"), headers=headers, follow_redirects=False, **sent)
        codes[answer.status_code] += 1
        found = wrong_answer(operation, answer, document)
        if answer.status_code >= 500 and answer.status_code not in {503, 507}:
            found.append(f"{answer.status_code}: {answer.text[:200]}")
        wrong += [f"{method} {path} {str(sent)[:300]}: {each}" for each in found]
    return wrong, codes


@pytest.mark.parametrize("role", ["owner", "reviewer"])
@pytest.mark.parametrize(
    ("count", "seed"), [(200, 1), pytest.param(2000, 2, marks=pytest.mark.long)], ids=["some", "many"]
)
def test_no_request_breaks_the_server_and_each_answer_fits(calibrated: Any, role: str, count: int, seed: int) -> None:
    wrong, codes = failures(calibrated, role, count, seed)
    assert wrong == []
    assert sum(codes.values()) == count
    assert codes.total() - codes[422] > count / 4  # requests that come through to what they ask for


def test_a_refusal_with_a_list_would_be_noticed(calibrated: Clinic) -> None:
    document: dict[str, Any] = calibrated.client.app.openapi()  # type: ignore[attr-defined]
    refused = document["paths"]["/api/v1/session"]["post"]["responses"]["4XX"]["content"]["application/json"]["schema"]
    assert list(misfits(refused, {"detail": "It is wrong."}, document)) == []
    assert list(misfits(refused, {"detail": [{"msg": "wrong"}]}, document))
    operations = [operation for path in document["paths"].values() for operation in path.values()]
    assert [one["operationId"] for one in operations if "422" in one.get("responses", {})] == []
