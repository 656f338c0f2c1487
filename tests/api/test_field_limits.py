"""The limits of requests that pages show, read from the models, and every one that a page asks for."""

import re
from typing import Any

import pytest

from folders import ROOT

ASKED = re.compile(r'(?:limitsOf|textLimits|numberLimits)\(\s*"(\w+)",\s*"(\w+)"')


@pytest.fixture
def limits(clinic: Any) -> dict[str, dict[str, dict[str, Any]]]:
    found: dict[str, dict[str, dict[str, Any]]] = clinic.good("GET", "/reference")["limits"]
    return found


def test_limits_are_those_of_the_models(limits: Any) -> None:
    none = dict.fromkeys(("minimum", "above", "maximum", "shortest", "longest", "usual"))
    assert limits["Speeds"]["forward"] == {**none, "above": 0.0, "maximum": 1.5, "usual": 0.8}
    assert limits["Speeds"]["jerk"] == {**none, "minimum": 0.5, "maximum": 20.0, "usual": 8.0}
    assert limits["NewPatient"]["code"] == {**none, "shortest": 1, "longest": 64}
    assert limits["BackupSettings"]["passphrase"] == {**none, "shortest": 8, "longest": 200}  # it may be null


def test_a_whole_number_above_a_limit_begins_at_the_next_one(limits: Any) -> None:
    port = limits["NewChair"]["port"]
    assert (port["minimum"], port["above"], port["maximum"]) == (1.0, None, 65_535.0)


def test_each_limit_that_a_page_asks_for_is_served(limits: Any) -> None:
    asked = {
        pair for file in (ROOT / "web_static" / "js").rglob("*.js") for pair in ASKED.findall(file.read_text("utf-8"))
    }
    assert len(asked) >= 20
    assert {(model, field) for model, field in asked if field not in limits.get(model, {})} == set()
