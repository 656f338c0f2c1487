"""How far exports are that are being made and sent, for the pages that asked for them."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Literal

State = Literal["going on", "complete", "broken off"]

MOST_COURSES = 50  # that are remembered, the newest; a page asks for a minute or so


class ExportCourse:
    """An export that is being made: its tables and documents, then one recording after the other."""

    def __init__(self, recordings: int) -> None:
        self.recordings = recordings
        self.packed = 0  # recordings
        self.sent = 0  # bytes
        self.state: State = "going on"


class ExportCourses:
    """The exports of late, by the person and the word by which the page of this person knows its export."""

    def __init__(self) -> None:
        self._of: dict[tuple[int, str], ExportCourse] = {}

    @contextmanager
    def begun(self, person_id: int, word: str | None, recordings: int) -> Iterator[ExportCourse]:
        """Yield the course of an export of so many recordings; without a word nobody asks for it.

        It is complete when the block ends, and broken off when an error or the end of the connection ends it.
        """
        course = ExportCourse(recordings)
        if word is not None:
            self._of.pop((person_id, word), None)
            self._of[person_id, word] = course
            for oldest in list(self._of)[:-MOST_COURSES]:
                del self._of[oldest]
        try:
            yield course
        except BaseException:
            course.state = "broken off"
            raise
        course.state = "complete"

    def of(self, person_id: int, word: str) -> ExportCourse | None:
        """Return a course, None when nobody began it yet, or long ago."""
        return self._of.get((person_id, word))
