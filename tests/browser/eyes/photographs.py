"""`python -m browser.eyes.photographs`: photographs every page in every state, for people to look at.

`make photographs CELLS="1280x800/dark 390x844/light"` writes one picture for each place and cell, as a person sees it
at first, one more of the whole page where it scrolls, and contact sheets.
"""

import argparse
import io
import shutil
import sys
import tempfile
from collections.abc import Container, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from browser.conftest import CHROMIUM, FewPicturesBrowser
from browser.eyes.axe import NOT_ON_TELEPHONES, SETTLE, THEMES
from browser.eyes.contact_sheets import save_sheets
from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.places import PLACES, put_back
from browser.sizes import SIZES, window
from PIL import Image
from playwright.sync_api import expect, sync_playwright

from folders import ROOT

OUT = ROOT / "build" / "photographs"
ZOOMS = {"100": 1, "200": 2, "400": 4}
STANDARD = (
    "1280x800/light 1280x800/dark 768x1024/light 768x1024/dark 768x1024/contrast 390x844/light 390x844/dark "
    "1280x800/forced 1280x800/light/200"
)
PATIENCE = 60_000  # ms
TALLEST = 6000  # px of a whole page
# How much taller the window must be to show the whole of what scrolls up and down.
HIDDEN = """() => Math.max(0, ...[document.scrollingElement, ...document.querySelectorAll("main, .app, .page, .sheet")]
  .map((one) => one.scrollHeight - one.clientHeight))"""


@dataclass(frozen=True)
class Cell:
    """A size in px, a theme, and how much the browser enlarges."""

    size: str
    theme: str
    zoom: str = "100"

    @property
    def name(self) -> str:
        """Return the name of its folder."""
        return f"{self.size}-{self.theme}" + ("" if self.zoom == "100" else f"-{self.zoom}")

    def has(self, place: str) -> bool:
        """Return whether people meet this place at this size."""
        return self.size != "390x844" or place not in NOT_ON_TELEPHONES

    def window(self) -> dict[str, int]:
        """Return width and height that the browser lays out, in px."""
        factor = ZOOMS[self.zoom]
        whole = window(self.size)
        return {"width": whole["width"] // factor, "height": whole["height"] // factor}


def cell(text: str) -> Cell:
    """Return the cell of a text such as 1280x800/dark or 1280x800/light/200 (a zoom in percent)."""
    parts = text.split("/")
    names_of: tuple[Container[str], ...] = (SIZES, THEMES, ZOOMS)
    known = zip(parts, names_of, strict=False)
    if len(parts) not in (2, 3) or not all(part in names for part, names in known):
        raise argparse.ArgumentTypeError(
            f"{text!r} is no cell: write SIZE/THEME or SIZE/THEME/ZOOM, with a size of {', '.join(SIZES)}, "
            f"a theme of {', '.join(THEMES)} and a zoom of {', '.join(ZOOMS)}"
        )
    return Cell(*parts)


def photograph(page: Any, one: Cell, file: Path) -> Path:
    """Write what the page shows in this cell, and where it scrolls, the whole of it; return the first file."""
    window = one.window()
    page.set_viewport_size(window)
    page.emulate_media(**THEMES[one.theme])
    page.wait_for_timeout(SETTLE)
    file.parent.mkdir(parents=True, exist_ok=True)
    _save(page, file)
    hidden = page.evaluate(HIDDEN)
    if hidden > 1:
        page.set_viewport_size({**window, "height": min(TALLEST, window["height"] + hidden)})
        page.wait_for_timeout(SETTLE)
        _save(page, file.with_stem(f"{file.stem}, whole"))
    return file


def _save(page: Any, file: Path) -> None:
    Image.open(io.BytesIO(page.screenshot(scale="css"))).convert("RGB").save(file, quality=85)


def take(page: Any, clinic: EyesClinic, cells: list[Cell], places: list[str], out: Path) -> None:
    """Photograph the places in the cells, into a folder for each cell, with contact sheets beside these folders."""
    pictures: dict[Cell, list[Path]] = {one: [] for one in cells}
    for name in places:
        page.emulate_media(**THEMES["light"])  # a page loaded in forced colours keeps their black in the next cells
        PLACES[name](page, clinic)
        page.wait_for_timeout(2 * SETTLE)
        for one in cells:
            if one.has(name):
                pictures[one].append(photograph(page, one, out / one.name / f"{name}.webp"))
        put_back(clinic)
        sys.stdout.write(f"{name}\n")
        sys.stdout.flush()
    for one, files in pictures.items():
        save_sheets(files, out / f"sheet-{one.name}")


@contextmanager
def owners_page() -> Iterator[tuple[Any, EyesClinic]]:
    """Give the clinic's owner's page, and the clinic."""
    expect.set_options(timeout=PATIENCE)
    with tempfile.TemporaryDirectory() as folder, EyesClinic(Path(folder)) as clinic, sync_playwright() as playwright:
        launched = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=list(CHROMIUM))
        page = FewPicturesBrowser(launched).new_context(storage_state=clinic.storage()).new_page()
        page.set_default_timeout(PATIENCE)
        yield page, clinic
        launched.close()


def arguments(argv: list[str]) -> argparse.Namespace:
    """Return what was asked for."""
    parser = argparse.ArgumentParser(prog="make photographs", description=__doc__)
    parser.add_argument("cells", nargs="*", type=cell, metavar="CELL", help="SIZE/THEME or SIZE/THEME/ZOOM")
    parser.add_argument("--places", default="", help="only the places whose names begin with this")
    parser.add_argument("--out", type=Path, default=OUT)
    asked = parser.parse_args(argv)
    asked.cells = asked.cells or [cell(text) for text in STANDARD.split()]
    asked.names = [name for name in PLACES if name.startswith(asked.places)]
    if not asked.names:
        parser.error(f"no place begins with {asked.places!r}: choose one of {', '.join(PLACES)}")
    return asked


if __name__ == "__main__":
    asked = arguments(sys.argv[1:])
    with owners_page() as (page, clinic):
        take(page, clinic, asked.cells, asked.names, asked.out)
    sys.stdout.write(f"The photographs are in {asked.out}.\n")
