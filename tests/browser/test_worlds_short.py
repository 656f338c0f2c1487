"""Two short tasks in a real browser; `make worlds` drives each task of each scene."""

import pytest
from browser.worlds import drive, open_drive_page, tasks
from processes.served_demo import bodydrive, printed_link

pytestmark = [pytest.mark.browser, pytest.mark.long]

SHORT = {("turning.easy", "left"): "Angle off the mark", ("backing.easy", "back"): "Distance driven"}


def test_a_turn_and_a_way_back_are_driven_and_measured_as_such(browser, page_log):
    with bodydrive("demo", "--port", "0") as process:
        try:
            link = printed_link(process)
            log = page_log(link)
            page = open_drive_page(browser, log, link)
            for floorplan, path in tasks():
                measure = SHORT.get((floorplan, path.name))
                if measure:
                    assert measure in drive(page, floorplan, path)
            log.assert_clean()
        finally:
            process.terminate()
            process.wait(20)
