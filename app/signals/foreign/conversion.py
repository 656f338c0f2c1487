"""The table of a foreign file, as the isolated reader has written it; that of the last file is kept."""

from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from app.isolated_reader import read_isolated
from app.signals.file_table import FilePart, FileTable
from app.signals.foreign.foreign_reading import PARQUET
from app.signals.foreign.kinds import ForeignKind
from app.signals.parquet_table import read_parquet_table
from app.texts import Text, from_document


class Conversion(NamedTuple):
    """What a foreign file holds."""

    table: FileTable | bytes  # or the table in text, in UTF-8
    rate: float | None  # Hz, as the file states it beside its rows
    parts: tuple[FilePart, ...]  # of which one can be read alone
    note: Text | None  # what was left out


def converted(path: Path, kind: ForeignKind, part: str | None = None) -> Conversion:
    """Return what a file holds, or one of its parts.

    Raises
    ------
    ValueError
        One sentence that names the file and what to do.
    """
    status = path.stat()
    return _converted(str(path), kind.name, part, status.st_mtime_ns, status.st_size)


@lru_cache(maxsize=1)
def _converted(file: str, kind: str, part: str | None, _changed: int, _size: int) -> Conversion:
    with TemporaryDirectory() as folder:
        question = {"file": file, "kind": kind, "part": part, "folder": folder}
        answer = read_isolated("app.signals.foreign.foreign_reading", question)
        table, rate = Path(folder, str(answer["table"])), answer["rate"]
        parts = tuple(FilePart(*each) for each in answer["parts"])
        said = None if answer["note"] is None else from_document(answer["note"])
        note = said if isinstance(said, Text) else None
        if answer["table"] != PARQUET:
            return Conversion(table.read_bytes(), rate, parts, note)
        read = read_parquet_table(table, (), None)
    return Conversion(replace(read, places=read.places._replace(file=file)), rate, parts, note)
