"""Two short tasks in a real browser; `make worlds` drives each task of each scene."""

import pytest
from browser.worlds import drive, open_drive_page, tasks

pytestmark = [pytest.mark.browser, pytest.mark.long]

SHORT = {("turning.easy", "left"): "Angle off the asked heading", ("backing.easy", "back"): "Distance driven"}


def test_a_turn_and_a_way_back_are_driven_and_measured_as_such(browser, page_log, demo):
    log = page_log(demo)
    page = open_drive_page(browser, log, demo)
    for floorplan, path in tasks():
        measure = SHORT.get((floorplan, path.name))
        if measure:
            assert measure in drive(page, floorplan, path)
    log.assert_clean()
