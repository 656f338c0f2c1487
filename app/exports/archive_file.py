"""The file of an archive: a zip file of JSON documents and recordings, each with its SHA-256.

`archive.json` comes first: the format, its schema, the name of the clinic, the files with size and hash, and one hash
of all files. Time and place of making are outside that hash, so every clinic writes the same hash for the same rows.
"""

import json
import re
import shutil
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from hashlib import sha256
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, ValidationError

from app.exports.package import add_file, entry
from app.quantities import Document

SCHEMA = 1
LIST, PATIENT = "archive.json", "patient.json"
RUN_ID = re.compile(r"[0-9A-Za-z-]{1,36}")
RUN_FILE = re.compile(
    r"runs/(?P<run>[0-9A-Za-z-]{1,36})/(run\.json|run\.parquet|end\.json|damaged\.txt|segment-\d{4}\.(arrows|check))"
)
LARGEST_DOCUMENT = 256_000_000  # bytes
CHUNK = 1 << 20  # bytes

NO_ARCHIVE = "{file}: this is no archive of bodydrive, or it was cut: name another file."
CHANGED = "{file}: '{name}' in it was changed or cut, and nothing was imported: copy the archive again."
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


def write_archive(package: Path, clinic: str, patient: bytes, folders: list[Path]) -> str:
    """Write an archive of the document `patient` and the recordings in `folders`; return its hash."""
    every = {f"runs/{file.parent.name}/{file.name}": file for folder in folders for file in folder.glob("*")}
    recordings = {name: every[name] for name in sorted(every) if RUN_FILE.fullmatch(name)}
    files = {PATIENT: FileEntry(bytes=len(patient), sha256=sha256(patient).hexdigest())}
    for name, file in recordings.items():
        files[name] = FileEntry(bytes=file.stat().st_size, sha256=_hash_of(file))
    listed = ArchiveList(clinic=clinic, hash=hash_of(files), files=files)
    package.unlink(missing_ok=True)
    with zipfile.ZipFile(package, "x") as opened:
        opened.writestr(entry(LIST), listed.model_dump_json(indent=1))
        opened.writestr(entry(PATIENT), patient)
        for name, file in recordings.items():
            add_file(opened, file, name, stored=True)
    return listed.hash


class OpenArchive:
    """An archive that is read; every message of its errors is one sentence that names the file."""

    def __init__(self, file: Path, opened: zipfile.ZipFile) -> None:
        self._file, self._zip = file, opened
        names = opened.namelist()
        if len(names) != len(set(names)) or names[:2] != [LIST, PATIENT]:
            raise ValueError(NO_ARCHIVE.format(file=file))
        content = self._content(LIST, LARGEST_DOCUMENT)
        try:
            schema = json.loads(content).get("schema_version")
            if isinstance(schema, int) and schema > SCHEMA:
                raise ValueError(NEWER.format(file=file, schema=schema))
            self.listed = ArchiveList.model_validate_json(content)
        except (ValidationError, json.JSONDecodeError, AttributeError, RecursionError) as error:
            raise ValueError(NO_ARCHIVE.format(file=file)) from error
        if set(names) != {LIST, *self.listed.files} or hash_of(self.listed.files) != self.listed.hash:
            raise ValueError(CHANGED.format(file=file, name=LIST))
        for info in opened.infolist()[2:]:
            known = self.listed.files[info.filename]
            if not RUN_FILE.fullmatch(info.filename) or info.compress_type != zipfile.ZIP_STORED:
                raise ValueError(NO_ARCHIVE.format(file=file))
            if info.file_size != known.bytes:
                raise ValueError(CHANGED.format(file=file, name=info.filename))

    @property
    def recording_bytes(self) -> int:
        """Return how much room the recordings need."""
        return sum(known.bytes for name, known in self.listed.files.items() if name != PATIENT)

    def patient(self) -> Any:
        """Return the document of the patient."""
        content = self._content(PATIENT, self.listed.files[PATIENT].bytes)
        if sha256(content).hexdigest() != self.listed.files[PATIENT].sha256:
            raise ValueError(CHANGED.format(file=self._file, name=PATIENT))
        try:
            return json.loads(content, parse_constant=_refuse_constant)
        except (ValueError, RecursionError) as error:
            raise ValueError(NO_ARCHIVE.format(file=self._file)) from error

    def unpack_recordings(self, folder: Path) -> None:
        """Write the recordings to `folder`, one folder each, and check their hashes."""
        for name, known in self.listed.files.items():
            if name == PATIENT:
                continue
            _, run, last = name.split("/")
            target = folder / run / last
            target.parent.mkdir(parents=True, exist_ok=True)
            try:
                with self._zip.open(name) as source, target.open("xb") as written:
                    shutil.copyfileobj(source, written, CHUNK)
            except (zipfile.BadZipFile, EOFError) as error:
                raise ValueError(CHANGED.format(file=self._file, name=name)) from error
            if _hash_of(target) != known.sha256:
                raise ValueError(CHANGED.format(file=self._file, name=name))

    def _content(self, name: str, most: int) -> bytes:
        """Return a file, of which no more than the permitted bytes are decompressed."""
        most = min(most, LARGEST_DOCUMENT)
        try:
            with self._zip.open(name) as source:
                content = source.read(most + 1)
        except (zipfile.BadZipFile, EOFError, OSError, NotImplementedError, RuntimeError, ValueError) as error:
            raise ValueError(CHANGED.format(file=self._file, name=name)) from error
        if len(content) > most:
            raise ValueError(CHANGED.format(file=self._file, name=name))
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


def _hash_of(file: Path) -> str:
    digest = sha256()
    with file.open("rb") as opened:
        while chunk := opened.read(CHUNK):
            digest.update(chunk)
    return digest.hexdigest()


def _refuse_constant(name: str) -> Any:
    raise ValueError(name)
