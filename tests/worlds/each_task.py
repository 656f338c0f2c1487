"""Each task of each scene, driven to its end by the simulated person in a real browser; `make worlds`.

Pictures of every task in every view, to be looked at, are put into var/worlds.
"""

import re
from collections.abc import Iterator

import pytest
from browser.conftest import browser, page_log  # noqa: F401  (fixtures)
from browser.worlds import drive, open_drive_page, tasks
from processes.served_demo import bodydrive, printed_link

from folders import ROOT

pytestmark = [pytest.mark.browser]

PICTURES = ROOT / "var" / "worlds"
VIEWS = ("Eye", "Chase", "Top", "Free")
DRAWN = 2500  # ms until another view is drawn, in software


@pytest.fixture(scope="module")
def page(browser, page_log) -> Iterator:  # noqa: F811
    """Yield one page of one demonstration, on which all tasks are driven."""
    with bodydrive("demo", "--port", "0") as process:
        try:
            link = printed_link(process)
            log = page_log(link)
            yield open_drive_page(browser, log, link)
            log.assert_clean()
        finally:
            process.terminate()
            process.wait(20)


@pytest.mark.parametrize("task", tasks(), ids=lambda task: f"{task[0]}-{task[1].name}")
def test_the_simulated_person_drives_it_to_its_end(page, task):
    name, path = task

    def take_pictures():
        for view in VIEWS:
            choice = page.get_by_role("radio", name=view, exact=True)
            if not choice.count():  # a short task may be done before all pictures are taken
                return
            choice.check(force=True)
            page.wait_for_timeout(DRAWN)
            page.screenshot(path=PICTURES / f"{name}-{path.name}-{view.lower()}.png")

    words = drive(page, name, path, take_pictures)
    assert re.search(r"^Time\s+[\d.]+ s", words, re.MULTILINE), words
