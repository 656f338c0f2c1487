"""The release of Python that reads zip and tar files safely is asked for, in one sentence."""

import pytest

from app.python_release import SAFE_FROM, python_warning


@pytest.mark.parametrize(("version", "least"), SAFE_FROM.items())
def test_the_release_before_is_warned_of_and_the_first_safe_one_is_not(version: tuple[int, int], least: int) -> None:
    words = python_warning((*version, least - 1))
    assert f"install Python {version[0]}.{version[1]}.{least} or newer." in words
    assert "\n" not in words
    assert python_warning((*version, least)) == ""


def test_a_later_version_is_safe() -> None:
    assert python_warning((3, 14, 0)) == ""
