"""Tables in plain text: titles and cells of a column end, or begin, below each other."""

from app.plain_table import column_widths, table_lines

ROWS = (("joint", "rate", "map"), ("left_elbow", "9 %", "standard"), ("wrist", "100 % / s", "-"))


def test_a_column_is_as_wide_as_its_longest_cell_or_title():
    assert table_lines(ROWS, left=(0, 2)) == [
        "joint            rate  map",
        "left_elbow        9 %  standard",
        "wrist       100 % / s  -",
    ]
    assert column_widths(ROWS) == [10, 9, 8]


def test_widths_may_be_given():
    assert table_lines([("", "over two")], [3, 12]) == ["         over two"]
