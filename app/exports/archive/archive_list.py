"""What is in the file of an archive: names, sizes, hashes, and one hash of all.

An archive is a zip file. Its directory begins with `archive.json`: the format, its schema, the name of the clinic, the
files with size and hash, and one hash of all files. Then come `patient.json`, `report.html` where there is one, and the
recordings. Time and place of making are outside the hash of all, so every clinic writes the same hash for the same
rows; so is `report.html`, the report of the patient's course for people, which names them.
"""

import re
from hashlib import sha256
from typing import Annotated, Literal

from pydantic import Field

from app.quantities import Document

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
    lines = "".join(f"{known.sha256}  {name}\n" for name, known in sorted(files.items()))
    return sha256(lines.encode()).hexdigest()


def entry_of(content: bytes) -> FileEntry:
    """Return size and hash of a file with this content."""
    return FileEntry(bytes=len(content), sha256=sha256(content).hexdigest())
