"""Reads one uploaded recording in the process of `app.isolated_reader`: what it holds, and its signals as Parquet.

The Parquet file is a recording of this program: `t` in seconds, and columns JOINT_NUMBER. Their metadata have the unit,
and the name that the column had.
"""

import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any, Final, TypedDict

import numpy as np

from app.signals.import_options import ImportOptions
from app.signals.joint_names import channel_names, proposed_joints
from app.signals.overview import ColumnOverview, FileOverview, overview
from app.signals.parquet_names import MOST_NUMBERS
from app.signals.signals import ReadingOptions, Signals
from app.texts import Text, to_document

WITH_NUMBERS: Final = frozenset(("channel", "constant", "unused"))  # roles of columns that can be channels


class ImportQuestion(TypedDict):
    """A file, `ImportOptions` as a document, and where the Parquet file goes; empty: nowhere."""

    file: str
    options: dict[str, Any]
    out: str


def answer(question: ImportQuestion) -> dict[str, object]:
    """Return what a file holds as `recording`, and write its signals where a place is given.

    Raises
    ------
    ValueError
        One sentence when the file cannot be read at all, or when a person must correct something before it is written.
    """
    options = ImportOptions.model_validate(question["options"])
    chosen = {channel.column: channel.joint for channel in options.channels or ()}
    reading = ReadingOptions(options.time, options.unit, options.rate, tuple(chosen) or None, options.part)
    with _temporary_files_in(Path(question["file"]).parent):
        found = overview(Path(question["file"]), None, reading)
    candidates = _candidates(found.columns)
    joints = {**proposed_joints(candidates), **chosen}
    if found.signals is not None and found.signals.values.size + len(found.signals.t) > MOST_NUMBERS:
        found = replace(found, problem=Text("signals-numbers", file=question["file"], most=MOST_NUMBERS))
    if question["out"]:
        if found.signals is None or found.problem is not None:
            raise ValueError(found.problem)
        _write(Path(question["out"]), found, found.signals, joints)
    return {"recording": _document(found, joints)}


@contextmanager
def _temporary_files_in(folder: Path) -> Iterator[None]:
    """Let what is read on the way lie beside the upload, so that it is removed with it, however this process ends."""
    before, tempfile.tempdir = tempfile.tempdir, str(folder)
    try:
        yield
    finally:
        tempfile.tempdir = before


def _candidates(columns: Sequence[ColumnOverview]) -> list[str]:
    """Return the columns that can be channels: those of numbers, where the file could be read as a whole."""
    are_known = any(column.missing is not None for column in columns)
    return [
        column.name
        for column in columns
        if column.role in WITH_NUMBERS and (column.missing is not None or not are_known)
    ]


def _document(found: FileOverview, joints: Mapping[str, str]) -> dict[str, object]:
    signals, dialect = found.signals, found.dialect
    sentence = None if dialect is None else dialect.sentence
    return {
        "kind": found.kind,
        "dialect": _said(sentence),
        "parts": [part._asdict() for part in found.parts],
        "rows": found.rows,
        "columns": [
            {
                "name": column.name,
                "unit": column.unit,
                "role": column.role,
                "least": column.least,
                "most": column.most,
                "missing": column.missing,
                "joint": joints.get(column.name),
            }
            for column in found.columns
        ],
        "time": found.time,
        "unit": found.unit,
        "rate": None if signals is None else signals.sample_rate,
        "seconds": None if signals is None else float(signals.t[-1] - signals.t[0]),
        "message": _said(None if signals is None else signals.damage),
        "problem": _said(found.problem),
    }


def _said(text: Text | str | None) -> Any:
    """Return a text as JSON, an empty one for none."""
    return "" if text is None else to_document(text)


def _write(path: Path, found: FileOverview, signals: Signals, joints: Mapping[str, str]) -> None:
    """Write the signals of the channels, named after their joints."""
    import pyarrow as pa
    import pyarrow.parquet as pa_parquet

    names = channel_names([joints[name] for name in signals.channel_names])
    units = {column.name: column.unit for column in found.columns}
    fields = [pa.field("t", pa.float64(), metadata={"unit": "s"})]
    for name, column in zip(names, signals.channel_names, strict=True):
        metadata = {"column": column} | ({"unit": units[column]} if units.get(column) else {})
        fields.append(pa.field(name, pa.float32(), metadata=metadata))
    values = [pa.array(signals.values[:, index].astype(np.float32)) for index in range(len(names))]
    table = pa.table([pa.array(signals.t), *values], schema=pa.schema(fields))
    pa_parquet.write_table(table, path, compression="zstd")
