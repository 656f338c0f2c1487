"""The file of an archive: what is in it (names, sizes, hashes, one hash of all), and how it is read with distrust.

An archive is a zip file. Its directory begins with `archive.json`: the format, its schema, the name of the clinic, the
files with size and hash, and one hash of all files. Then come `patient.json`, `report.html` where there is one, and the
recordings. Time and place of making are outside the hash of all, so every clinic writes the same hash for the same
rows; so is `report.html`, the report of the patient's course for people, which names them. Whatever is wrong with a
file that is read is one sentence.
"""

import json
import re
import shutil
import struct
import zipfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from hashlib import sha256
from lzma import LZMAError
from math import isfinite
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, ValidationError

from app.quantities import Document
from app.texts import Text

SCHEMA = 1
LIST, PATIENT, REPORT = "archive.json", "patient.json", "report.html"
RUN_ID = re.compile(r"[0-9A-Za-z-]{1,36}")
RUN_FILE = re.compile(
    r"runs/(?P<run>[0-9A-Za-z-]{1,36})/(run\.json|run\.parquet|end\.json|damaged\.txt|segment-\d{4}\.(arrows|check))"
)
CHUNK = 1 << 20  # bytes


class FileEntry(Document):
    """Size and hash of a file."""

    bytes: Annotated[int, Field(ge=0, le=2**50)]
    sha256: Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]


class ArchiveList(Document):
    """The content of `archive.json`."""

    format: Literal["bodydrive-archive"] = "bodydrive-archive"
    schema_version: Annotated[int, Field(ge=1)] = SCHEMA
    clinic: Annotated[str, Field(max_length=80)]
    hash: Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]
    files: dict[str, FileEntry]
    report: FileEntry | None = None  # None: there is none


def hash_of(files: dict[str, FileEntry]) -> str:
    """Return the hash of an archive: SHA-256 of a line `HASH  NAME` for each file, in the order of the names."""
    lines = "".join(f"{entry.sha256}  {name}\n" for name, entry in sorted(files.items()))
    return sha256(lines.encode()).hexdigest()


def entry_of(content: bytes) -> FileEntry:
    """Return size and hash of a file with this content."""
    return FileEntry(bytes=len(content), sha256=sha256(content).hexdigest())


LARGEST_DOCUMENT = 256_000_000  # bytes
LARGEST_WHOLE = 2**63 - 1

# What the library raises for a file that was changed anywhere.
DAMAGED = (
    zipfile.BadZipFile,
    zlib.error,
    LZMAError,
    struct.error,
    EOFError,
    NotImplementedError,
    RuntimeError,
    KeyError,
)
UNREADABLE = (*DAMAGED, OSError, ValueError)


class OpenArchive:
    """An archive that is read; every message of its errors is one sentence that names the file."""

    def __init__(self, file: Path, opened: zipfile.ZipFile) -> None:
        self.file, self._zip = file, opened
        names = opened.namelist()
        if len(names) != len(set(names)) or names[:2] != [LIST, PATIENT]:
            raise _no_archive(file)
        document = self._document(self._content(LIST, LARGEST_DOCUMENT))
        schema = document.get("schema_version") if isinstance(document, dict) else None
        if isinstance(schema, int) and schema > SCHEMA:
            raise ValueError(Text("archive-newer", file=str(file), schema=schema))
        try:
            self.listed = ArchiveList.model_validate(document)
        except ValidationError as error:
            raise _no_archive(file) from error
        expected = [LIST, PATIENT] if self.listed.report is None else [LIST, PATIENT, REPORT]
        is_listed = set(names) == {*expected, *self.listed.files} and names[: len(expected)] == expected
        if not is_listed or PATIENT not in self.listed.files or hash_of(self.listed.files) != self.listed.hash:
            raise _changed(file, LIST)
        if self.listed.report is not None:
            self._checked(REPORT, self.listed.report)
        for info in opened.infolist()[len(expected) :]:
            entry = self.listed.files[info.filename]
            if not RUN_FILE.fullmatch(info.filename) or info.compress_type != zipfile.ZIP_STORED:
                raise _no_archive(file)
            if info.file_size != entry.bytes:
                raise _changed(file, info.filename)

    def recording_bytes(self, without: frozenset[str]) -> int:
        """Return how much room the recordings need, without those of these names."""
        return sum(entry.bytes for _, _, entry in self._recordings(without))

    def patient(self) -> Any:
        """Return the document of the patient."""
        return self._document(self._checked(PATIENT, self.listed.files[PATIENT]))

    def _recordings(self, without: frozenset[str]) -> Iterator[tuple[str, str, FileEntry]]:
        """Yield name in the archive, recording, size and hash of each recorded file."""
        for name, entry in self.listed.files.items():
            if name != PATIENT and (run := name.split("/")[1]) not in without:
                yield name, run, entry

    def unpack_recordings(self, folder: Path, without: frozenset[str]) -> None:
        """Write the recordings to `folder`, one folder each, without those of these names; check their hashes."""
        for name, run, entry in self._recordings(without):
            target = folder / run / name.rpartition("/")[2]
            target.parent.mkdir(parents=True, exist_ok=True)
            try:
                with self._zip.open(name) as source, target.open("xb") as written:
                    shutil.copyfileobj(source, written, CHUNK)
            except DAMAGED as error:
                raise _changed(self.file, name) from error
            if _hash_of(target) != entry.sha256:
                raise _changed(self.file, name)

    def _checked(self, name: str, entry: FileEntry) -> bytes:
        """Return a file whose hash is right."""
        content = self._content(name, entry.bytes)
        if entry_of(content) != entry:
            raise _changed(self.file, name)
        return content

    def _document(self, content: bytes) -> Any:
        """Return a JSON document, in which all texts and numbers are such as a database stores."""
        try:
            document = json.loads(content, parse_constant=_finite, parse_float=_finite, parse_int=_whole)
            json.dumps(document, ensure_ascii=False).encode()  # refuses halves of surrogate pairs
        except (ValueError, RecursionError) as error:
            raise _no_archive(self.file) from error
        return document

    def _content(self, name: str, most: int) -> bytes:
        """Return a file, of which no more than the permitted bytes are decompressed."""
        most = min(most, LARGEST_DOCUMENT)
        try:
            with self._zip.open(name) as source:
                content = source.read(most + 1)
        except UNREADABLE as error:
            raise _changed(self.file, name) from error
        if len(content) > most:
            raise _changed(self.file, name)
        return content


@contextmanager
def open_archive(file: Path) -> Iterator[OpenArchive]:
    """Open an archive to read it; ValueError with one sentence when it is none, cut, or of a newer program."""
    try:
        opened = zipfile.ZipFile(file)
    except UNREADABLE as error:
        raise _no_archive(file) from error
    with opened:
        yield OpenArchive(file, opened)


def _no_archive(file: Path) -> ValueError:
    return ValueError(Text("archive-none", file=str(file)))


def _changed(file: Path, name: str) -> ValueError:
    return ValueError(Text("archive-changed", file=str(file), name=name))


def _hash_of(file: Path) -> str:
    digest = sha256()
    with file.open("rb") as opened:
        while chunk := opened.read(CHUNK):
            digest.update(chunk)
    return digest.hexdigest()


def _finite(text: str) -> float:
    number = float(text)
    if not isfinite(number):
        raise ValueError(text)
    return number


def _whole(text: str) -> int:
    number = int(text)
    if not -LARGEST_WHOLE <= number <= LARGEST_WHOLE:
        raise ValueError(text)
    return number
