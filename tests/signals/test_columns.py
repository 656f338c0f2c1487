"""A table reads equal in every dialect of CSV, and the dialect is reported."""

import csv
import io

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.signals.columns import read_columns, read_table
from app.signals.csv_dialect import Dialect

NUMBERS = st.floats(-1e6, 1e6, allow_nan=False).map(lambda value: round(value, 6)) | st.just(float("nan"))
ROWS = st.integers(1, 5).map(lambda width: st.lists(NUMBERS, min_size=width, max_size=width))
TABLES = ROWS.flatmap(lambda row: st.lists(row, min_size=1))
DIALECTS = st.sampled_from(
    [Dialect(*signs) for signs in ((",", "."), (";", "."), (";", ","), ("\t", "."), ("\t", ","))]
)


def written(rows, dialect, ending="\n", mark="", quoted=csv.QUOTE_MINIMAL):
    text = io.StringIO()
    writer = csv.writer(text, delimiter=dialect.separator, lineterminator=ending, quoting=quoted)
    writer.writerow(["t", *(f"c{i}" for i in range(len(rows[0])))])
    for number, row in enumerate(rows):
        cells = [number / 100, *row]
        writer.writerow(["NaN" if np.isnan(cell) else repr(cell).replace(".", dialect.decimal) for cell in cells])
    return (mark + text.getvalue()).encode()


@given(
    TABLES,
    DIALECTS,
    st.sampled_from(["\n", "\r\n"]),
    st.sampled_from(["", "\ufeff"]),
    st.sampled_from([csv.QUOTE_MINIMAL, csv.QUOTE_ALL]),
)
def test_any_dialect_of_a_table_reads_equal(tmp_path_factory, rows, dialect, ending, mark, quoted):
    file = tmp_path_factory.getbasetemp() / "table.csv"
    file.write_bytes(written(rows, Dialect()))
    plain = read_columns(file)
    file.write_bytes(written(rows, dialect, ending, mark, quoted))
    found = read_table(file)
    assert list(found.columns) == list(plain)
    for name, values in plain.items():
        np.testing.assert_array_equal(found.columns[name], values)
    assert found.dialect[:2] == dialect[:2]


def test_text_with_commas_does_not_mean_decimal_commas(tmp_path):
    file = tmp_path / "table.csv"
    file.write_text("t;a;remark\n0.5;1.25;up, then down\n")
    found = read_table(file, only=("t", "a"))
    assert (float(found.columns["t"][0]), float(found.columns["a"][0])) == (0.5, 1.25)
    assert found.dialect == Dialect(";", ".")


def test_a_small_file_that_holds_very_many_numbers_is_not_unpacked(tmp_path):
    file = tmp_path / "table.parquet"
    zeros = pa.array([0.0]).take(pa.array(np.zeros(1_000_000, np.int8)))
    with pq.ParquetWriter(file, pa.schema({"t": pa.float64()}), compression="zstd") as writer:
        for _ in range(201):
            writer.write_table(pa.table({"t": zeros}))
    with pytest.raises(ValueError, match="more than 200,000,000 numbers"):
        read_columns(file)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("t;a\n0,5;1\n0,6;x\n", "line 3, column 'a': 'x' is not a number"),
        ("t;a\n0,5;1.5\n", "line 2, column 'a': '1.5' is not a number"),
        ("t;a\n0,5;1;2\n", "line 2: 3 cells where the header has 2"),
        ("t;a\n0,5;1.234,5\n", "'1.234,5' is not a number"),
    ],
)
def test_an_error_is_described_in_the_dialect_of_the_file(tmp_path, content, words):
    file = tmp_path / "table.csv"
    file.write_text(content)
    with pytest.raises(ValueError, match="table") as refused:
        read_columns(file)
    assert words in str(refused.value)
