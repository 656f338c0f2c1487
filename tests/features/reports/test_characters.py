"""The characters of the fonts, and what stands in place of others."""

import json
import unicodedata

from fontTools.ttLib import TTFont
from hypothesis import given
from hypothesis import strategies as st

from app.features.reports.characters import COVERAGE, coverage_of_fonts, missing_text, printable, without_invisible
from app.settings import data_folder

FONTS = data_folder() / "fonts"
LARGEST = 12_000_000  # bytes of all fonts: a wheel must stay small


def test_the_list_of_characters_is_that_of_the_fonts():
    found = set()
    for file in FONTS.glob("Noto*"):
        with TTFont(file, lazy=True) as font:
            found |= set(font.getBestCmap())
    listed = {number for first, last in json.loads((FONTS / COVERAGE).read_text()) for number in range(first, last + 1)}
    assert listed == found
    assert sum(file.stat().st_size for file in FONTS.iterdir()) < LARGEST
    assert (FONTS / "OFL.txt").read_text().count("SIL OPEN FONT LICENSE") >= 1


@given(st.text())
def test_a_printed_text_has_only_characters_of_the_fonts(text):
    coverage = coverage_of_fonts()
    visible = without_invisible(text)
    shown = printable(visible, coverage)
    assert all(one in coverage or one in "\n\t" for one in shown)
    assert not any(unicodedata.category(one) in {"Cc", "Cf", "Cs", "Co", "Cn"} for one in visible if one not in "\n\t")
    assert (missing_text([visible], coverage) is None) == (shown == visible)
    assert printable(shown, coverage) == shown
