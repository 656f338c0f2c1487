"""`make photographs`: each asked cell has its pictures and a sheet, and a wrong wish is refused in a sentence."""

import pytest
from browser.eyes.contact_sheets import GAP, WORDS, save_sheets
from browser.eyes.photographs import Cell, arguments, take
from browser.eyes.places import PLACES
from PIL import Image

pytestmark = pytest.mark.browser


def test_each_cell_has_its_pictures_and_a_sheet(page, clinic, tmp_path) -> None:
    cells = [Cell("390x844", "dark"), Cell("1280x800", "light", "200")]
    take(page, clinic, cells, ["patients", "drive"], tmp_path)
    sizes = {}
    for file in tmp_path.rglob("*.*p*"):
        with Image.open(file) as picture:
            sizes[str(file.relative_to(tmp_path))] = picture.size
    assert sizes["390x844-dark/patients.webp"] == (390, 844)
    assert "390x844-dark/drive.webp" not in sizes  # nobody drives by a telephone
    assert sizes["1280x800-light-200/drive.webp"] == (640, 400)
    whole = sizes["1280x800-light-200/drive, whole.webp"]
    assert whole[0] == 640
    assert whole[1] > 400
    assert {"sheet-390x844-dark-1.png", "sheet-1280x800-light-200-1.png"} <= sizes.keys()


def test_a_sheet_is_full_before_the_next_begins(tmp_path) -> None:
    files = [tmp_path / f"{number}.webp" for number in range(14)]
    for file in files:
        Image.new("RGB", (1280, 800), "#336699").save(file)
    first, second = save_sheets(files, tmp_path / "sheet")
    with Image.open(first) as whole, Image.open(second) as rest:
        assert whole.size[0] == rest.size[0]
        height = rest.size[1] - GAP  # one row
        assert (whole.size[1] - GAP) == 4 * height
        assert height > WORDS + GAP


def test_without_a_wish_every_place_is_photographed() -> None:
    asked = arguments([])
    assert asked.names == list(PLACES)
    assert {cell.theme for cell in asked.cells} == {"light", "dark", "contrast", "forced"}
    assert arguments(["--places", "patients, n", "768x1024/contrast"]).cells == [Cell("768x1024", "contrast")]


@pytest.mark.parametrize("wish", [["12x12/light"], ["1280x800"], ["1280x800/pink"], ["1280x800/dark/150"], ["a/b/c/d"]])
def test_a_cell_that_does_not_exist_is_refused(wish, capsys) -> None:
    with pytest.raises(SystemExit):
        arguments(wish)
    assert "is no cell: write SIZE/THEME" in capsys.readouterr().err


def test_a_place_that_does_not_exist_is_refused(capsys) -> None:
    with pytest.raises(SystemExit):
        arguments(["--places", "attic"])
    assert "no place begins with 'attic'" in capsys.readouterr().err
