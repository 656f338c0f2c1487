"""`python -m sources_tried`: each source of movements, from `make demo` to a scored trial; `make sources-tried`."""

import argparse
import importlib.util
import sys
import tempfile
from functools import partial
from pathlib import Path

from browser.conftest import PROGRAM
from playwright.sync_api import sync_playwright
from sensors.__main__ import keep_lsl_local
from sources_tried.figures import Tried, row, section, table, with_section
from sources_tried.files import FILES, try_file
from sources_tried.sources import SOURCES
from sources_tried.story import try_source

from bench.tables import here
from folders import ROOT

PHOTOGRAPHS = ROOT / "build" / "sources-tried"


def main() -> int:
    """Try the sources, print their table, and return 0 when each came to its end."""
    names = [*(source.name for source in SOURCES), *FILES]
    parser = argparse.ArgumentParser(prog="python -m sources_tried", description=main.__doc__)
    parser.add_argument("--only", nargs="+", choices=names, default=names, help="these sources, or kinds of files")
    parser.add_argument("--photographs", type=Path, default=PHOTOGRAPHS, help="a folder for the photographs")
    parser.add_argument("--out", type=Path, help="write the table of all into this page, below what it has")
    given = parser.parse_args()
    if given.out and given.only != names:
        parser.error("--out writes all sources: name none")
    if PROGRAM is None:
        parser.error("there is no chromium here: install Debian's package 'chromium'")
    given.photographs.mkdir(parents=True, exist_ok=True)
    all_tried: list[Tried] = []
    with tempfile.TemporaryDirectory() as place, sync_playwright() as playwright:
        folder = Path(place)
        has_lsl = keep_lsl_local(folder)
        left_out = [source.name for source in SOURCES if lacks_library(source.library, has_lsl=has_lsl)]
        tries = {source.name: partial(try_source, playwright, source) for source in SOURCES}
        tries |= {kind: partial(try_file, playwright, kind) for kind in FILES}
        for name in names:
            if name not in given.only or name in left_out:
                continue
            sys.stderr.write(f"{name} ...\n")
            try:
                tried = tries[name](folder / name, given.photographs)
            except Exception as error:  # whatever ends one source, the others are tried
                tried = Tried(name, stopped=f"{type(error).__name__}: {error}")
            all_tried.append(tried)
            sys.stderr.write(row(tried))
    sys.stdout.write(table(all_tried))
    if left_out:
        sys.stdout.write(f"Without its library: {', '.join(left_out)}.\n")
    if given.out:
        measured = here()
        day = f"{measured.day.day} {measured.day:%B %Y}"
        before = given.out.read_text(encoding="utf-8") if given.out.exists() else ""
        part = section(all_tried, left_out, day, measured.commit, measured.machine)
        given.out.write_text(with_section(before, part), encoding="utf-8")
    return 0 if all(tried.is_good for tried in all_tried) else 1


def lacks_library(library: str, *, has_lsl: bool) -> bool:
    """Return whether a library of Python is missing; of LSL, its library in C counts as well."""
    if library == "pylsl":
        return not has_lsl
    return bool(library) and importlib.util.find_spec(library) is None


if __name__ == "__main__":
    sys.exit(main())
