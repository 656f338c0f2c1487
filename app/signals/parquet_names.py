"""Reads the names of a Parquet file's columns, without its numbers."""

from io import BytesIO
from pathlib import Path

MOST_NUMBERS = 40_000_000  # as many as a CSV file of 64 MB can hold; Parquet packs equal values
MOST_COLUMNS = 1000
LONGEST_SCHEMA = 1_000_000  # bytes
END = 8  # bytes: u32 little-endian length of the schema, then a magic word (Parquet format, File Format)


def parquet_names(source: Path | bytes) -> list[str] | None:
    """Return the names of the columns of a file, or of its content; None when unreadable or too large."""
    import pyarrow
    import pyarrow.parquet

    try:
        with source.open("rb") if isinstance(source, Path) else BytesIO(source) as opened:
            size = opened.seek(0, 2)
            opened.seek(max(size - END, 0))
            if int.from_bytes(opened.read(4), "little") > LONGEST_SCHEMA:
                return None
            metadata = pyarrow.parquet.read_metadata(opened)
            many = metadata.num_columns > MOST_COLUMNS or metadata.num_rows * metadata.num_columns > MOST_NUMBERS
            return None if many else list(metadata.schema.to_arrow_schema().names)
    except (ValueError, OSError, pyarrow.ArrowException):
        return None
