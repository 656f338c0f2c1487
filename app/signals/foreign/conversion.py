"""The table of a foreign file, as the isolated reader has written it; that of the last file is kept."""

from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory

from app.isolated_reader import read_isolated
from app.signals.file_table import FileTable
from app.signals.foreign.foreign_reading import PARQUET
from app.signals.foreign.kinds import ForeignKind
from app.signals.parquet_table import read_parquet_table
from app.texts import Text, from_document


def converted(path: Path, kind: ForeignKind) -> FileTable | bytes:
    """Return the table of a file, or the table in text that it holds.

    Raises
    ------
    ValueError
        One sentence that names the file and what to do.
    """
    status = path.stat()
    return _converted(str(path), kind.name, status.st_mtime_ns, status.st_size)


@lru_cache(maxsize=1)
def _converted(file: str, kind: str, _changed: int, _size: int) -> FileTable | bytes:
    with TemporaryDirectory() as folder:
        answer = read_isolated("app.signals.foreign.foreign_reading", {"file": file, "kind": kind, "folder": folder})
        table = Path(folder, str(answer["table"]))
        if answer["table"] != PARQUET:
            return table.read_bytes()
        read = read_parquet_table(table, (), None)
    note = None if answer["note"] is None else from_document(answer["note"])
    return FileTable(
        read.columns,
        read.units,
        read.places._replace(file=file),
        note=note if isinstance(note, Text) else None,
    )
