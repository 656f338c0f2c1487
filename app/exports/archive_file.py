"""The file of an archive: a zip file of JSON documents and recordings, each with its SHA-256.

`archive.json` comes first: the format, its schema, the name of the clinic, the files with size and hash, and one hash
of all files. Time and place of making are outside that hash, so every clinic writes the same hash for the same rows;
so is `report.html`, the report of the patient's course for people, which names them.
"""

import json
import re
import shutil
import zipfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from hashlib import sha256
from math import isfinite
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, ValidationError

from app.exports.package import Step, add_file, entry
from app.quantities import Document

SCHEMA = 2  # 1: without report and comments
LIST, PATIENT, REPORT = "archive.json", "patient.json", "report.html"
RUN_ID = re.compile(r"[0-9A-Za-z-]{1,36}")
RUN_FILE = re.compile(
    r"runs/(?P<run>[0-9A-Za-z-]{1,36})/(run\.json|run\.parquet|end\.json|damaged\.txt|segment-\d{4}\.(arrows|check))"
)
LARGEST_DOCUMENT = 256_000_000  # bytes
LARGEST_WHOLE = 2**63 - 1
CHUNK = 1 << 20  # bytes

NO_ARCHIVE = "{file}: this is no archive of bodydrive, or it was cut: name another file."
CHANGED = "{file}: '{name}' in the archive was changed or cut, and nothing was imported: copy the archive again."
NEWER = (
    "{file}: this archive was made by a newer bodydrive (schema {schema}), and nothing was imported: update this one."
)


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


MakeReport = Callable[[], bytes]


def archive_steps(clinic: str, tables: Any, folders: list[Path], make_report: MakeReport | None) -> list[Step]:
    """Return the steps that write an archive of a patient's rows and of the recordings in `folders`.

    They are called one after the other with the file to be made. `make_report` returns the content of `report.html`;
    None: there is no report.
    """
    folders = sorted(folders)
    begin = partial(_begin, clinic, tables, folders, make_report)
    return [begin, *(partial(_add_recording, folder) for folder in folders)]


def _begin(clinic: str, tables: Any, folders: list[Path], make_report: MakeReport | None, package: Path) -> int:
    patient = json.dumps({"tables": tables}, indent=1, sort_keys=True, ensure_ascii=False).encode()
    report = None if make_report is None else make_report()
    files = {PATIENT: _entry_of(patient)}
    for folder in folders:
        for name, file in recorded_files(folder):
            files[name] = FileEntry(bytes=file.stat().st_size, sha256=_hash_of(file))
    report_entry = None if report is None else _entry_of(report)
    listed = ArchiveList(clinic=clinic, hash=hash_of(files), files=files, report=report_entry)
    package.unlink(missing_ok=True)
    with zipfile.ZipFile(package, "x") as opened:
        opened.writestr(entry(LIST), listed.model_dump_json(indent=1))
        opened.writestr(entry(PATIENT), patient)
        if report is not None:
            opened.writestr(entry(REPORT), report)
        return opened.start_dir


def _add_recording(folder: Path, package: Path) -> int:
    with zipfile.ZipFile(package, "a") as opened:
        for name, file in recorded_files(folder):
            add_file(opened, file, name, stored=True)
        return opened.start_dir


def recorded_files(folder: Path) -> list[tuple[str, Path]]:
    """Return the files of a recording that belong to an archive, with their names in it."""
    named = [(f"runs/{folder.name}/{file.name}", file) for file in sorted(folder.glob("*"))]
    return [(name, file) for name, file in named if RUN_FILE.fullmatch(name)]


class OpenArchive:
    """An archive that is read; every message of its errors is one sentence that names the file."""

    def __init__(self, file: Path, opened: zipfile.ZipFile) -> None:
        self.file, self._zip = file, opened
        names = opened.namelist()
        if len(names) != len(set(names)) or names[:2] != [LIST, PATIENT]:
            raise ValueError(NO_ARCHIVE.format(file=file))
        document = self._document(self._content(LIST, LARGEST_DOCUMENT))
        schema = document.get("schema_version") if isinstance(document, dict) else None
        if isinstance(schema, int) and schema > SCHEMA:
            raise ValueError(NEWER.format(file=file, schema=schema))
        try:
            self.listed = ArchiveList.model_validate(document)
        except ValidationError as error:
            raise ValueError(NO_ARCHIVE.format(file=file)) from error
        expected = [LIST, PATIENT] if self.listed.report is None else [LIST, PATIENT, REPORT]
        is_listed = set(names) == {*expected, *self.listed.files} and names[: len(expected)] == expected
        if not is_listed or hash_of(self.listed.files) != self.listed.hash:
            raise ValueError(CHANGED.format(file=file, name=LIST))
        if self.listed.report is not None:
            self._checked(REPORT, self.listed.report)
        for info in opened.infolist()[len(expected) :]:
            known = self.listed.files[info.filename]
            if not RUN_FILE.fullmatch(info.filename) or info.compress_type != zipfile.ZIP_STORED:
                raise ValueError(NO_ARCHIVE.format(file=file))
            if info.file_size != known.bytes:
                raise ValueError(CHANGED.format(file=file, name=info.filename))

    def recording_bytes(self, without: frozenset[str]) -> int:
        """Return how much room the recordings need, without those of these names."""
        return sum(known.bytes for _, _, known in self._recordings(without))

    def patient(self) -> Any:
        """Return the document of the patient."""
        return self._document(self._checked(PATIENT, self.listed.files[PATIENT]))

    def _recordings(self, without: frozenset[str]) -> Iterator[tuple[str, str, FileEntry]]:
        """Yield name in the archive, recording, size and hash of each recorded file."""
        for name, known in self.listed.files.items():
            if name != PATIENT and (run := name.split("/")[1]) not in without:
                yield name, run, known

    def unpack_recordings(self, folder: Path, without: frozenset[str]) -> None:
        """Write the recordings to `folder`, one folder each, without those of these names; check their hashes."""
        for name, run, known in self._recordings(without):
            target = folder / run / name.rpartition("/")[2]
            target.parent.mkdir(parents=True, exist_ok=True)
            try:
                with self._zip.open(name) as source, target.open("xb") as written:
                    shutil.copyfileobj(source, written, CHUNK)
            except (zipfile.BadZipFile, EOFError) as error:
                raise ValueError(CHANGED.format(file=self.file, name=name)) from error
            if _hash_of(target) != known.sha256:
                raise ValueError(CHANGED.format(file=self.file, name=name))

    def _checked(self, name: str, known: FileEntry) -> bytes:
        """Return a file whose hash is right."""
        content = self._content(name, known.bytes)
        if _entry_of(content) != known:
            raise ValueError(CHANGED.format(file=self.file, name=name))
        return content

    def _document(self, content: bytes) -> Any:
        """Return a JSON document, in which all texts and numbers are such as a database stores."""
        try:
            document = json.loads(content, parse_constant=_finite, parse_float=_finite, parse_int=_whole)
            json.dumps(document, ensure_ascii=False).encode()  # refuses halves of surrogate pairs
        except (ValueError, RecursionError) as error:
            raise ValueError(NO_ARCHIVE.format(file=self.file)) from error
        return document

    def _content(self, name: str, most: int) -> bytes:
        """Return a file, of which no more than the permitted bytes are decompressed."""
        most = min(most, LARGEST_DOCUMENT)
        try:
            with self._zip.open(name) as source:
                content = source.read(most + 1)
        except (zipfile.BadZipFile, EOFError, OSError, NotImplementedError, RuntimeError, ValueError) as error:
            raise ValueError(CHANGED.format(file=self.file, name=name)) from error
        if len(content) > most:
            raise ValueError(CHANGED.format(file=self.file, name=name))
        return content


@contextmanager
def open_archive(file: Path) -> Iterator[OpenArchive]:
    """Open an archive to read it; ValueError with one sentence when it is none, cut, or of a newer program."""
    try:
        opened = zipfile.ZipFile(file)
    except (zipfile.BadZipFile, OSError, ValueError, NotImplementedError) as error:
        raise ValueError(NO_ARCHIVE.format(file=file)) from error
    with opened:
        yield OpenArchive(file, opened)


def hash_of(files: dict[str, FileEntry]) -> str:
    """Return the hash of an archive: SHA-256 of a line `HASH  NAME` for each file, in the order of the names."""
    lines = "".join(f"{known.sha256}  {name}\n" for name, known in sorted(files.items()))
    return sha256(lines.encode()).hexdigest()


def _entry_of(content: bytes) -> FileEntry:
    return FileEntry(bytes=len(content), sha256=sha256(content).hexdigest())


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
