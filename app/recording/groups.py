"""Reads a recorded run in groups of rows, so that a long one needs little memory."""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from app.recording.format import END_FILE, META_KEY, PARQUET_FILE, Columns, parse_end
from app.recording.reader import RunRecording, columns_of, file_checksum, read_run
from app.texts import Text

GROUP = 20_000  # rows


@dataclass(frozen=True, slots=True)
class RunGroups:
    """A recorded run that is read group by group; the groups can be iterated once."""

    meta: dict[str, Any]  # the content of `run.json`
    loss: Text | None  # what is damaged, and how much a cut lost at most; None: the recording is whole and closed
    groups: Iterator[Columns]  # at least one, which may have no rows


def read_in_groups(folder: Path) -> RunGroups:
    """Return the run in `folder`; one that is not whole and closed is read into memory, up to its damage.

    Raises
    ------
    ValueError
        One sentence, when the folder holds no recording.
    """
    file = folder / PARQUET_FILE
    try:
        end = parse_end((folder / END_FILE).read_bytes())
    except OSError:
        end = None
    if end is None or end["checksums"].get(PARQUET_FILE) != file_checksum(file):
        run = read_run(folder)
        return RunGroups(run.meta, run.loss, _slices(run))
    return _closed_run(file)


def _closed_run(file: Path) -> RunGroups:
    import pyarrow as pa
    import pyarrow.parquet as pa_parquet

    opened = pa_parquet.ParquetFile(file)
    meta = json.loads(opened.schema_arrow.metadata[META_KEY])

    def groups() -> Iterator[Columns]:
        with opened:
            empty = True
            for batch in opened.iter_batches(GROUP):
                yield columns_of([pa.Table.from_batches([batch])], meta)
                empty = False
            if empty:
                yield columns_of([], meta)

    return RunGroups(meta, None, groups())


def _slices(run: RunRecording) -> Iterator[Columns]:
    for start in range(0, max(run.rows, 1), GROUP):
        yield {name: column[start : start + GROUP] for name, column in run.columns.items()}
