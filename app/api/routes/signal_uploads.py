"""Uploads of recorded signals and bodies: check size, type, name and content."""

import re
from functools import lru_cache
from pathlib import Path
from typing import BinaryIO, Literal

from fastapi import HTTPException

from app.computing_process import ComputingProcess
from app.quantities import Document
from app.refusals import Unavailable
from app.signals.parquet_names import MOST_NUMBERS, parquet_names
from app.signals.table_form import HEAD, form_of_head
from app.signals.time_names import time_names
from app.store.files.name_conflicts import SameName
from app.store.files.replacements import ReplacedFiles
from app.texts import Text

MOST_SIGNAL_BYTES = 64_000_000  # of a file
KINDS = (".csv", ".parquet")
KEPT = 100  # files of which the names are in memory: the list is asked for by every page

FileKind = Literal["signals", "body", "head", "recording"]
HEAD_COLUMNS = {"yaw_deg", "pitch_deg", "roll_deg"}


class FileView(Document):
    """A file to choose from."""

    name: str
    kind: FileKind
    size: int


def list_files(folder: Path, computing: ComputingProcess) -> list[FileView]:
    """List the files in `folder` that a shirt or a body can be played from; what cannot be read is left out."""
    files = []
    for file in sorted(folder.glob("*")) if folder.is_dir() else []:
        if file.name.startswith("."):
            continue
        if file.is_dir():
            size = sum(part.stat().st_size for part in file.iterdir() if part.is_file())
            files.append(FileView(name=file.name, kind="recording", size=size))
        elif file.is_file() and file.suffix in KINDS:
            status = file.stat()
            columns = _names_of_file(computing, file, status.st_mtime_ns, status.st_size)
            if columns is not None:
                files.append(FileView(name=file.name, kind=_kind(columns), size=status.st_size))
    return files


def keep_upload(
    shelf: ReplacedFiles, computing: ComputingProcess, name: str, content: BinaryIO, same_name: SameName
) -> FileView:
    """Store an uploaded file under a harmless name, atomically.

    Raises
    ------
    HTTPException
        With one sentence: 413 when it is too large, 415 when it is of another type, 422 when it cannot be read.
    NameTaken
        When the name is taken, and nobody chose.
    """
    safe = harmless_name(name)
    if Path(safe).suffix not in KINDS:
        raise HTTPException(415, Text("api-wrong-upload", name=safe))
    data = content.read(MOST_SIGNAL_BYTES + 1)
    if len(data) > MOST_SIGNAL_BYTES:
        raise HTTPException(413, Text("api-upload-too-large", name=safe, megabytes=MOST_SIGNAL_BYTES // 1_000_000))
    if not data:
        raise HTTPException(422, Text("api-upload-empty", name=safe))
    # Check before writing: an unreadable file must not replace a good one of the same name.
    columns = _parquet_names(computing, data) if safe.endswith(".parquet") else _csv_names(data[:HEAD])
    if columns is None or not time_names(columns) or len(columns) < 2:
        raise HTTPException(422, Text("api-upload-columns", name=safe, count=MOST_NUMBERS))
    return FileView(name=put_file(shelf, safe, data, same_name), kind=_kind(columns), size=len(data))


def put_file(shelf: ReplacedFiles, name: str, content: bytes, same_name: SameName) -> str:
    """Store a file and return its name; errors as of `ReplacedFiles.put`, and 409 when it cannot be written."""
    try:
        return shelf.put("file", name, content, same_name)
    except OSError as error:
        raise HTTPException(
            409, Text("api-upload-not-kept", name=name, problem=error.strerror or str(error))
        ) from error


def harmless_name(name: str, longest: int = 60) -> str:
    """Return a file name without folders, leading dots or characters that a shell or a page could misread.

    What stands in front of its ending has at most `longest` letters.
    """
    last = re.split(r"[/\\]", name)[-1]
    stem, dot, suffix = last.rpartition(".")
    clean = re.sub(r"[^A-Za-z0-9_-]+", "-", stem or suffix).strip("-")[:longest] or "file"
    ending = re.sub(r"[^a-z0-9]", "", suffix.lower())[:8]
    return f"{clean}.{ending}" if dot and ending else clean


@lru_cache(maxsize=KEPT)
def _names_of_file(computing: ComputingProcess, file: Path, _changed: int, _size: int) -> list[str] | None:
    """Return the names of a file's columns; the same for as long as the file was not changed."""
    if file.suffix == ".parquet":
        return _parquet_names(computing, file)
    with file.open("rb") as opened:
        return _csv_names(opened.read(HEAD))


def _parquet_names(computing: ComputingProcess, source: Path | bytes) -> list[str] | None:
    try:
        return computing.ask(parquet_names, source)
    except Unavailable:  # reading this file ended the process
        return None


def _csv_names(head: bytes) -> list[str] | None:
    """Return the names of the columns of a table in text that begins with `head`; None when unreadable."""
    try:
        form = form_of_head(head, "")
    except ValueError:
        return None
    return [name for name in form.names if name]


def _kind(columns: list[str]) -> FileKind:
    """Return the kind of a file by its columns; those of a body are JOINT_x, JOINT_y, JOINT_z."""
    times = time_names(columns)
    others = [column for column in columns if column not in times]
    if set(others) >= HEAD_COLUMNS:
        return "head"
    turns = {column[:-2] for column in others if column.endswith("_x")}
    body = bool(turns) and all(f"{joint}_{axis}" in others for joint in turns for axis in "xyz")
    return "body" if body and len(others) == 3 * len(turns) else "signals"
