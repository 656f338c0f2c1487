"""What others wrote, in one line that people can read."""

from hypothesis import given
from hypothesis import strategies as st

from app.visible_text import one_line


@given(st.text(), st.integers(1, 40))
def test_one_line_is_printable_and_short_and_stays_as_it_is(text: str, longest: int) -> None:
    line = one_line(text, longest)
    assert line.isprintable()
    assert len(line) <= longest
    assert line == line.strip()
    assert one_line(line, longest) == line
    assert one_line(text).startswith(line)


def test_spaces_stand_for_what_cannot_be_printed() -> None:
    assert one_line("no\nsuch \x1b[1m\u202eport\t") == "no such [1m port"
    assert one_line("no such port", 8) == "no such"
    assert one_line("\n\u200b") == ""
