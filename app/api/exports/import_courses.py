"""How far the imports of archives are, for the pages of those who import them."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Literal

from app.store.files.passing_folder import bytes_in

FILE, RECORDINGS = "archive.zip", "recordings"  # in the folder of an import

Step = Literal["send", "unpack"]


class ImportCourse:
    """An import under way: first its file arrives, then its recordings are checked and unpacked."""

    def __init__(self, folder: Path, total: int) -> None:
        self.file, self.recordings = folder / FILE, folder / RECORDINGS
        self.step: Step = "send"
        self._folder = folder
        self._sent = total  # bytes that the browser announced; 0: none
        self._unpacked = 0  # bytes, the most that were seen: at the end the recordings are moved to their place

    def begin_to_unpack(self) -> None:
        """Note that the whole file is here."""
        self.step = "unpack"

    def moved(self) -> int:
        """Return a number that changes while the import goes on."""
        return bytes_in(self._folder)

    def bytes(self) -> tuple[int, int]:
        """Return how many bytes of this step are done, and of how many; 0 of 0 while that is not known."""
        size = self.file.stat().st_size if self.file.exists() else 0
        if self.step == "send":
            return min(size, self._sent), self._sent
        self._unpacked = max(self._unpacked, bytes_in(self.recordings))
        return min(self._unpacked, size), size


class ImportCourses:
    """The imports under way, one for each person: the newest."""

    def __init__(self) -> None:
        self._of: dict[int, ImportCourse] = {}

    @contextmanager
    def begun(self, person_id: int, folder: Path, total: int) -> Iterator[ImportCourse]:
        """Keep the course of an import of `total` bytes in `folder` as long as it goes on."""
        course = self._of[person_id] = ImportCourse(folder, total)
        try:
            yield course
        finally:
            if self._of.get(person_id) is course:
                del self._of[person_id]

    def of(self, person_id: int) -> ImportCourse | None:
        """Return the course of a person's import, None when there is none."""
        return self._of.get(person_id)
