"""Hebrew and Arabic in the PDF of a report: every letter is there, and a name runs from right to left.

The order is read from the places of the drawn letters, not from the order of the characters in the file.
"""

import unicodedata
from dataclasses import replace
from itertools import pairwise

import pypdfium2
import pytest
from features.reports.words_of import letters
from pypdfium2 import raw

from app.features.reports.document import Remark
from app.features.reports.rendering import render_pdf

NAMES = {"Hebrew": "גל כהן שמעבד", "Arabic": "محمد بن سعيد"}  # no lam before alef, which are drawn as one glyph
LINES = ("{}", "Seen with {} at 10:30", "{} 12")  # alone, within another script, before a number


def drawn(content: bytes, is_of_script) -> list[tuple[float, float, str]]:
    """Return the letters of a script on the first page as (left, right, letter) in points, the leftmost first."""
    document = pypdfium2.PdfDocument(content)
    try:
        page = document[0].get_textpage()
        found = []
        for index in range(page.count_chars()):
            letter = unicodedata.normalize("NFKC", chr(raw.FPDFText_GetUnicode(page, index)))
            if is_of_script(letter):
                left, _, right, _ = page.get_charbox(index)
                found.append((left, right, letter))
        return sorted(found)
    finally:
        document.close()


@pytest.mark.parametrize("line", LINES)
@pytest.mark.parametrize("script", NAMES)
def test_a_name_runs_from_right_to_left(session_report, script, line):
    name = NAMES[script]

    def is_of_script(letter: str) -> bool:
        return script.upper() in unicodedata.name(letter[0], "")

    report = replace(session_report, notes=(Remark("", line.format(name)),))
    found = drawn(render_pdf(report, "a4"), is_of_script)
    assert "".join(letter for _, _, letter in reversed(found)) == letters(name)
    assert all(right > left for left, right, _ in found)
    assert all(first[0] < second[0] for first, second in pairwise(found))  # side by side, not over each other
