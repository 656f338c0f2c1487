"""A recording as one Parquet file with a column for each number."""

import json
from pathlib import Path
from typing import Any

from app.features.exports.flat_table import flat_tables
from app.recording.format import META_KEY
from app.recording.groups import RunGroups


def write_parquet(run: RunGroups, facts: dict[str, Any], folder: Path, stem: str) -> list[Path]:
    """Write `STEM.parquet`, with `facts` as JSON under the key `bodydrive` of its metadata; return the file."""
    import pyarrow.parquet as pa_parquet

    file = folder / f"{stem}.parquet"
    writer: Any = None
    for table in flat_tables(run):
        if writer is None:
            schema = table.schema.with_metadata({META_KEY: json.dumps(facts)})
            writer = pa_parquet.ParquetWriter(file, schema, compression="zstd", use_dictionary=False)
        writer.write_table(table.cast(writer.schema))
    writer.close()
    return [file]
