"""Send a zip file while a process of its own makes it, and say how far it is, for the page that asked for it."""

from collections.abc import Iterator
from contextlib import AbstractContextManager, closing, contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Annotated, Literal

from fastapi import APIRouter, Depends, Query
from fastapi.responses import StreamingResponse

from app.api.deps import Exporter
from app.api.parts import part, parts_for
from app.api.sign_in.identity import SignedInPerson
from app.clock import utc_now
from app.computing_process import ComputingProcess
from app.download_name import download_name
from app.package import Step
from app.quantities import Document
from app.settings import Settings
from app.store.files.temporary_folders import bytes_in, temporary_folder

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


router = APIRouter(tags=["exports"])

CHUNK = 1 << 18  # bytes


ExportsPart = Annotated[ExportCourses, Depends(part(ExportCourses))]
CourseWord = Annotated[str, Query(pattern=r"^[0-9a-z-]{8,40}$")]


class ExportCourseView(Document):
    """How far an export is: recordings that are packed, of how many, and bytes that are sent."""

    packed: int
    recordings: int
    sent: int
    state: State


@router.get("/exports")
def export_course(course: CourseWord, person: Exporter, exports: ExportsPart) -> ExportCourseView | None:
    """Return how far an export of the person who asks is, by the word that it was begun with; null when none has it."""
    progress = exports.of(person.person_id, course)
    if progress is None:
        return None
    return ExportCourseView(
        packed=progress.packed,
        recordings=progress.recordings,
        sent=progress.sent,
        state=progress.state,
    )


@dataclass(frozen=True, slots=True)
class PackageDownload:
    """Sends zip files while they are made."""

    settings: Settings
    exports: ExportCourses

    def sent(
        self, steps: list[Step], recordings: int, form: str, person: SignedInPerson, course: str | None
    ) -> StreamingResponse:
        """Answer with the zip file of these steps; the first packs no recording, the next ones one each.

        With a word in `course`, `GET /exports?course=WORD` says meanwhile how far it is.
        """
        name = download_name(form, utc_now(), "zip")
        headers = {"Content-Disposition": f'attachment; filename="{name}"'}
        begun = self.exports.begun(person.person_id, course, recordings)
        return StreamingResponse(
            _content(steps, self.settings.state, begun), media_type="application/zip", headers=headers
        )


Download = Annotated[PackageDownload, Depends(parts_for(PackageDownload))]


def _content(steps: list[Step], state: Path, begun: AbstractContextManager[ExportCourse]) -> Iterator[bytes]:
    """Yield the zip file as far as it is final, after each step; its parts lie in a folder that is removed.

    The steps have a process of their own: the computing process of the clinic stays free for trials.
    """
    with begun as course, temporary_folder(state, "export") as folder, closing(ComputingProcess()) as computing:
        package = folder / "export.zip"
        for number, step in enumerate(steps):
            final = computing.ask_while(partial(bytes_in, folder), partial(step, package))
            course.packed = min(number, course.recordings)
            yield from _between(package, course, final)
        yield from _between(package, course, package.stat().st_size)


def _between(file: Path, course: ExportCourse, end: int) -> Iterator[bytes]:
    """Yield what was not sent yet of a file, up to a byte."""
    with file.open("rb") as opened:
        opened.seek(course.sent)
        while course.sent < end and (content := opened.read(min(CHUNK, end - course.sent))):
            course.sent += len(content)
            yield content
