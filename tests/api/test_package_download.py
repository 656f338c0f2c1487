"""How far an export is: asked for by a word, complete or broken off at the end, and nobody else's."""

from contextlib import suppress
from typing import Any

import pytest

from app.api import package_download
from app.api.package_download import ExportCourses, _content

WORD = "0123abcd-word"


def step(package: Any) -> int:
    """Add ten bytes to the file, which are then final."""
    with package.open("ab") as opened:
        opened.write(b"0123456789")
    return int(package.stat().st_size)


class InPlace:
    """Does the steps in this process, which knows the steps of this file."""

    def ask_while(self, progress: Any, do: Any) -> Any:
        assert progress() >= 0
        return do()

    def close(self) -> None:
        pass


@pytest.fixture(autouse=True)
def in_place(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(package_download, "ComputingProcess", InPlace)


class Broken(Exception):  # noqa: N818
    """What a step raises."""


def broken(package: Any) -> int:
    raise Broken


def course_of(courses: ExportCourses) -> tuple[int, int, int, str]:
    found = courses.of(1, WORD)
    assert found is not None
    return found.packed, found.recordings, found.sent, found.state


def test_the_course_goes_on_with_the_file_and_is_complete_at_its_end(tmp_path: Any) -> None:
    courses = ExportCourses()
    assert courses.of(1, WORD) is None
    content = _content([step, step, step], tmp_path, courses.begun(1, WORD, 2))
    seen = []
    for piece in content:
        assert len(piece) == 10
        seen.append(course_of(courses))
    assert seen == [(0, 2, 10, "going on"), (1, 2, 20, "going on"), (2, 2, 30, "going on")]
    assert course_of(courses) == (2, 2, 30, "complete")
    assert courses.of(2, WORD) is None  # another person
    assert list(tmp_path.glob(".export-*")) == []


@pytest.mark.parametrize("is_closed", [True, False])
def test_a_step_that_fails_or_a_reader_who_goes_breaks_it_off(tmp_path: Any, is_closed: bool) -> None:
    courses = ExportCourses()
    content = _content([step, broken], tmp_path, courses.begun(1, WORD, 1))
    next(content)
    if is_closed:
        content.close()  # type: ignore[attr-defined]
    else:
        with suppress(Broken):
            next(content)
    assert course_of(courses) == (0, 1, 10, "broken off")
    assert list(tmp_path.glob(".export-*")) == []


def test_only_the_newest_courses_are_remembered(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(package_download, "MOST_COURSES", 2)
    courses = ExportCourses()
    for word in ("one", "two", "three", None):
        with courses.begun(1, word, 1):
            pass
    assert [courses.of(1, word) is None for word in ("one", "two", "three")] == [True, False, False]
