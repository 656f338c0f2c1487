"""The page for clinicians has a section on "Drive now", with its picture and the seconds that the program takes."""

from app.calibration.prior.documents import FEWEST_PEOPLE
from app.calibration.script import calibration_script
from app.hardware.shirt.standard import standard_layout
from app.settings import docs_folder
from folders import ROOT


def section() -> str:
    page = (docs_folder() / "clinicians.md").read_text()
    return page.partition("### Drive now")[2].partition("\n### ")[0]


def test_it_says_how_long_rest_and_free_movement_take() -> None:
    steps = [step for step in calibration_script(standard_layout()) if step.kind != "prompt"]
    assert f"{sum(step.duration for step in steps):g} seconds" in section()


def test_it_shows_the_page_and_says_what_is_needed() -> None:
    assert "pictures/drive-now.webp" in section()
    assert (ROOT / "docs" / "pictures" / "drive-now.webp").is_file()
    assert FEWEST_PEOPLE == 4
    assert "at least four" in section()
    assert "real chair" in section()
