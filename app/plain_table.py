"""Tables in plain text, in a font of fixed width."""

from collections.abc import Collection, Sequence

BETWEEN = "  "  # columns

Row = Sequence[object]


def column_widths(rows: Sequence[Row]) -> list[int]:
    """Return the length of the longest cell of each column; all rows have as many cells."""
    return [max(len(str(cell)) for cell in column) for column in zip(*rows, strict=True)]


def table_lines(rows: Sequence[Row], widths: Sequence[int] | None = None, left: Collection[int] = (0,)) -> list[str]:
    """Return one line for each row, the row of titles included.

    `widths` are those of the columns, without them those of the longest cells. The columns in `left` begin below each
    other, the others end below each other.
    """
    return [
        BETWEEN.join(
            f"{cell!s:<{width}}" if column in left else f"{cell!s:>{width}}"
            for column, (cell, width) in enumerate(zip(row, widths or column_widths(rows), strict=True))
        ).rstrip()
        for row in rows
    ]
