"""Makes the fonts of reports in data/fonts/: `make shipped FILE=fonts`.

Their source are Debian's packages fonts-noto-core and fonts-noto-cjk.

A report must show names of many scripts on a machine without fonts. The subsets leave out hints, which a PDF does not
need, and of the ideographs all that the national standards of China, Taiwan, Japan and Korea do not list.
"""

import json
import sys
from pathlib import Path

from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTCollection, TTFont

from app.settings import data_folder

WHOLE = (
    *("NotoSans-Regular", "NotoSans-Bold", "NotoSansHebrew-Regular", "NotoSansHebrew-Bold"),
    *("NotoSansArabic-Regular", "NotoSansArabic-Bold"),
)
SIGNS = "NotoSansMath-Regular.ttf"  # of it, arrows and mathematical operators
IDEOGRAPHS = "NotoSansCJK-Regular.ttc"
SIMPLIFIED = "Noto Sans CJK SC"  # the face of the collection whose forms are used for characters that countries share
STANDARDS = ("gb2312", "big5", "shift_jis", "euc_kr")
COVERAGE = "coverage.json"


def main(packages: Path) -> None:
    """Write the subsets and the list of their characters; `packages` is a folder with the unpacked fonts."""
    folder = data_folder() / "fonts"
    covered: set[int] = set()
    for name in WHOLE:
        font = TTFont(next(packages.rglob(f"{name}.ttf")))
        covered |= subset(font, set(font.getBestCmap()), folder / f"{name}.ttf")
    signs = TTFont(next(packages.rglob(SIGNS)))
    covered |= subset(signs, set(range(0x2190, 0x2300)) & set(signs.getBestCmap()), folder / SIGNS)
    faces = TTCollection(next(packages.rglob(IDEOGRAPHS))).fonts
    face = next(one for one in faces if one["name"].getDebugName(1) == SIMPLIFIED)
    covered |= subset(face, common_ideographs() & set(face.getBestCmap()), folder / "NotoSansCJKsc-Regular.otf")
    (folder / COVERAGE).write_text(json.dumps(ranges(covered)) + "\n")


def subset(font: TTFont, characters: set[int], file: Path) -> set[int]:
    """Write a font with these characters and without hints; return the characters that it has."""
    options = Options(hinting=False, desubroutinize=False, notdef_outline=True, name_IDs=["*"], layout_features=["*"])
    options.drop_tables += ["MERG", "meta", "VORG", "vhea", "vmtx", "BASE"]
    made = Subsetter(options)
    made.populate(unicodes=characters)
    made.subset(font)
    font.save(file)
    return set(TTFont(file).getBestCmap())


def common_ideographs() -> set[int]:
    """Return the characters beyond Latin that the national standards list, and all syllables of Hangul."""
    found = set(range(0xAC00, 0xD7A4)) | set(range(0xFF01, 0xFFEF))
    for number in (*range(0x2300, 0xD800), *range(0xF900, 0xFFF0)):
        for standard in STANDARDS:
            try:
                chr(number).encode(standard)
            except UnicodeEncodeError:
                continue
            found.add(number)
            break
    return found


def ranges(characters: set[int]) -> list[list[int]]:
    """Return characters as ranges [first, last], in order."""
    found: list[list[int]] = []
    for number in sorted(characters):
        if found and number == found[-1][1] + 1:
            found[-1][1] = number
        else:
            found.append([number, number])
    return found


if __name__ == "__main__":
    main(Path(sys.argv[1]))
