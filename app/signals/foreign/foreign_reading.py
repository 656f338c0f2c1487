"""Reads one foreign file in the process of `app.isolated_reader`, and writes what it holds in a form of our own."""

from importlib import import_module
from pathlib import Path
from typing import Final, TypedDict

from app.signals.foreign.kinds import KINDS
from app.signals.foreign.recording import ForeignRecording, ForeignText, MissingLibraryError
from app.texts import Text, text_of, to_document

PARQUET: Final = "table.parquet"
TEXT: Final = "table.tsv"
FEWEST: Final = 2  # rows of a recording


class FileQuestion(TypedDict):
    """A file, the name of its kind, the part that is read alone, and the folder that the table is written to."""

    file: str
    kind: str
    part: str | None
    folder: str


def answer(question: FileQuestion) -> dict[str, object]:
    """Write the table of a file into `question["folder"]`: its name there, what was left out, the file's parts.

    Raises
    ------
    ValueError
        One sentence: the file, what is wrong, what to do.
    """
    file, folder = question["file"], Path(question["folder"])
    kind = next(each for each in KINDS if each.name == question["kind"])
    try:
        read = import_module(kind.module).read(Path(file), question["part"])
    except MissingLibraryError as error:
        raise ValueError(
            Text("signals-library-missing", file=file, kind=kind.name, library=str(error), extra=kind.extra)
        ) from error
    except MemoryError:
        raise
    except Exception as error:  # whatever a library raises for a damaged file
        if isinstance(text_of(error), Text):
            raise
        raise ValueError(Text("signals-foreign-damaged", file=file, kind=kind.name)) from error
    if isinstance(read, ForeignText):
        (folder / TEXT).write_text(read.text, encoding="utf-8")
        return _answer(TEXT, read)
    if not read.columns or len(next(iter(read.columns.values()))) < FEWEST:
        raise ValueError(Text("signals-foreign-empty", file=file, kind=kind.name))
    _write(folder / PARQUET, read)
    return _answer(PARQUET, read)


def _answer(table: str, read: ForeignRecording | ForeignText) -> dict[str, object]:
    note = None if read.note is None else to_document(read.note)
    return {"table": table, "note": note, "rate": read.rate, "parts": [*read.parts]}


def _write(path: Path, recording: ForeignRecording) -> None:
    import pyarrow as pa
    import pyarrow.parquet as pa_parquet

    fields = [
        pa.field(name, pa.float64(), metadata={"unit": recording.units[name]} if name in recording.units else None)
        for name in recording.columns
    ]
    table = pa.table([pa.array(values) for values in recording.columns.values()], schema=pa.schema(fields))
    pa_parquet.write_table(table, path, compression="zstd")
