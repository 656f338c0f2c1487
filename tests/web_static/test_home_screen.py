"""What a tablet needs to put the program on its home screen: the manifest and its icons."""

import json
import re
from typing import Any

import pytest
from PIL import Image
from web_static.home_screen_icons import ICONS, STATIC, TEAL

from folders import ROOT

MANIFEST = json.loads((STATIC / "bodydrive.webmanifest").read_text())


def test_the_manifest_opens_the_program_full_screen() -> None:
    assert (MANIFEST["start_url"], MANIFEST["scope"], MANIFEST["display"]) == ("/", "/", "fullscreen")
    named = {icon["src"] for icon in MANIFEST["icons"]}
    drawn = {f"icons/{name}.png" for name, _, _ in ICONS}
    assert drawn - named == {"icons/apple-180.png"}
    assert named <= drawn
    entry = (STATIC / "index.html").read_text()
    assert 'rel="manifest" href="bodydrive.webmanifest"' in entry
    assert 'rel="apple-touch-icon" href="icons/apple-180.png"' in entry


def test_one_colour_is_that_of_the_pages_the_home_screen_and_the_reports() -> None:
    """Files that read no style sheet repeat the colour of the light theme."""
    match = re.search(r"^  --teal: (#\w{6});$", (STATIC / "css" / "tokens.css").read_text(), flags=re.MULTILINE)
    assert match
    assert MANIFEST["theme_color"] == TEAL == match[1]
    repeat_it = ("web_static/icon.svg", "data/reports/report.css", "data/reports/report.typ")
    assert [name for name in repeat_it if TEAL not in (ROOT / name).read_text()] == []


@pytest.mark.parametrize(("name", "size", "share"), ICONS)
def test_each_icon_has_its_size_and_its_margin(name: str, size: int, share: float) -> None:
    with Image.open(STATIC / "icons" / f"{name}.png") as opened:
        icon = opened.convert("RGBA")
    assert icon.size == (size, size)
    declared = {entry["src"]: entry["sizes"] for entry in MANIFEST["icons"]}
    assert declared.get(f"icons/{name}.png", f"{size}x{size}") == f"{size}x{size}"
    pixels = [icon.getpixel((x, y)) for x in range(size) for y in range(size)]
    assert len(set(pixels)) > 10
    corner: Any = icon.getpixel((1, 1))
    assert corner == ((0, 0, 0, 0) if share == 1.0 else (11, 107, 107, 255))
    if share == 0.8:  # what a round mask cuts off has no drawing in it
        outside: set[Any] = {
            icon.getpixel((x, y))
            for x in range(size)
            for y in range(size)
            if (x + 0.5 - size / 2) ** 2 + (y + 0.5 - size / 2) ** 2 > (0.4 * size) ** 2
        }
        assert all(abs(a - b) <= 2 for pixel in outside for a, b in zip(pixel, corner, strict=True))  # soft edges
