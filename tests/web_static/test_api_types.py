"""The types that web_static/js is checked with are those of the application as it is."""

import pytest

from api_types import GENERATOR, TYPES, generated


def test_the_types_of_the_api_are_up_to_date():
    if not GENERATOR.exists():
        pytest.skip("the generator of types is not installed: run `make check` once")
    assert TYPES.read_text(encoding="utf-8") == generated(), "run `make api-types`"
