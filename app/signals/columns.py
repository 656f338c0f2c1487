"""Reads the columns of a file of signals, whatever its kind, and says in one sentence what is wrong with a bad one."""

from collections.abc import Collection
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from app.recording.reader import both
from app.signals.file_table import Columns, FilePart, FileTable
from app.signals.foreign.conversion import converted
from app.signals.foreign.kinds import foreign_kind
from app.signals.foreign.recording import OWN_TIME
from app.signals.parquet_table import columns_of_words, parquet_schema, read_parquet_table, units_of_schema
from app.signals.table_form import HEAD, TableForm, form_of_head
from app.signals.text_table import form_of_file, read_text_content, read_text_table
from app.texts import Text

PARQUET = ".parquet"
PARQUET_KIND, TEXT_KIND = "Parquet", "CSV"


class NamedColumns(NamedTuple):
    """The columns of a file without their numbers."""

    names: tuple[str, ...]
    units: dict[str, str]  # of the columns that have one
    texts: frozenset[str]  # columns of words
    place: Text | str  # of the names
    kind: str = TEXT_KIND  # of the file: "CSV" for all tables in text
    parts: tuple[FilePart, ...] = ()  # of which one can be read alone; empty where there is one table


def read_columns(path: Path, text: Collection[str] = (), only: Collection[str] | None = None) -> Columns:
    """Return the columns of a file by name; parameters and errors as of `read_table`."""
    return read_table(path, text, only).columns


def read_table(
    path: Path, text: Collection[str] = (), only: Collection[str] | None = None, part: str | None = None
) -> FileTable:
    """Read the columns of a file by name: float64 or float32 (n,), missing numbers as NaN, moments in s.

    Columns named in `text` are read as text. Of the others, those named in `only` are read (all that hold numbers when
    None); names that the file does not have are not in the answer. A file that ends in `.parquet` is Parquet; the
    kinds of `app/signals/foreign/kinds.py` are known by their names or beginnings; any other file is a table in text
    (`app/signals/table_form.py` finds its form). `part` is the stream or the sheet that is read alone.

    Raises
    ------
    ValueError
        One sentence that names the file, the line and column, and what to do.
    """
    _check_is_file(path)
    try:
        if _is_parquet(path):
            return read_parquet_table(path, text, only)
        if (kind := foreign_kind(path)) is None:
            return read_text_table(path, text, only)
        read, rate, _, note = converted(path, kind, part)
    except OSError as error:
        raise _unreadable(path, error) from error
    table = read.only(only) if isinstance(read, FileTable) else read_text_content(read, str(path), text, only)
    return replace(table, rate=table.rate or rate, note=both(note, table.note))


def named_columns(path: Path, part: str | None = None) -> NamedColumns:
    """Return the names of a file's columns, and their units; parameter and errors as of `read_table`."""
    _check_is_file(path)
    try:
        if _is_parquet(path):
            schema = parquet_schema(path)
            names, units = tuple(schema.names), units_of_schema(schema)
            return NamedColumns(names, units, columns_of_words(schema), str(path), PARQUET_KIND)
        if (kind := foreign_kind(path)) is None:
            return _of_form(form_of_file(path), path)
        read, _, parts, _ = converted(path, kind, part)
    except OSError as error:
        raise _unreadable(path, error) from error
    if isinstance(read, FileTable):
        return NamedColumns(tuple(read.columns), dict(read.units), frozenset(), str(path), kind.name, parts)
    return _of_form(form_of_head(read[:HEAD], str(path)), path)._replace(kind=kind.name, parts=parts)


def _of_form(form: TableForm, path: Path) -> NamedColumns:
    """Return the columns of a table in text, with one time in place of those of groups."""
    times = {form.names[index] for index in form.groups}
    named = [index for index, name in enumerate(form.names) if name and name not in times]
    units = {
        form.names[index]: "s" if form.kinds[index] == "moment" else form.units[index]
        for index in named
        if form.units[index] or form.kinds[index] == "moment"
    }
    names = tuple(dict.fromkeys(form.names[index] for index in named))
    if times:
        names, units = (OWN_TIME, *names), {OWN_TIME: "s", **units}
    words = frozenset(form.names[index] for index in named if form.kinds[index] == "text")
    return NamedColumns(names, units, words, form.header_place(str(path)))


def _check_is_file(path: Path) -> None:
    if not path.exists():
        raise ValueError(Text("signals-file-missing", file=str(path)))
    if path.is_dir():
        raise ValueError(Text("signals-folder", file=str(path)))
    if not path.is_file():
        raise ValueError(Text("signals-device", file=str(path)))


def _unreadable(path: Path, error: OSError) -> ValueError:
    return ValueError(Text("signals-file-unreadable", file=str(path), reason=error.strerror or str(error)))


def _is_parquet(path: Path) -> bool:
    return path.suffix.lower() == PARQUET
