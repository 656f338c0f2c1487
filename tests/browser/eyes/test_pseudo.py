"""In the pseudo language no page shows an English word, and none overflows, read from the left or from the right.

The pages of daily work are looked at on a telephone here, and by `make browser` all of them in each size.
"""

import pytest
from browser.eyes.axe import NOT_ON_TELEPHONES, look_as
from browser.eyes.places import PLACES, put_back
from browser.eyes.pseudo_clinic import english_words, pseudo_clinic
from browser.eyes.sweep import lost
from browser.script import script
from browser.sizes import SIZES, TOO_WIDE

pytestmark = [pytest.mark.browser]

TELEPHONE = "390x844"
NOT_HERE = NOT_ON_TELEPHONES | {"plans, unsaved"}  # the page of "plans, edit", too
SHORT = ("drive tasks", "calibrate", "review", "settings")
IN_ENGLISH = ("docs", "docs clinicians")  # the documentation is in English
OVER_STOP = script("over_stop")
TURN = "(direction) => { document.documentElement.dir = direction; }"
CHARTS_SETTLE = 450  # ms until charts have followed the window


@pytest.fixture(scope="module")
def eyes_clinic(tmp_path_factory):
    """Yield the clinic, which serves in the pseudo language."""
    with pseudo_clinic(tmp_path_factory.mktemp("pseudo")) as served:
        yield served


def overflows(page):
    """Return what does not have the room that it needs."""
    found = lost(page) + page.evaluate(OVER_STOP) + ["too wide"] * page.evaluate(TOO_WIDE)
    if not found:
        return found
    page.wait_for_timeout(CHARTS_SETTLE)
    return lost(page) + page.evaluate(OVER_STOP) + ["too wide"] * page.evaluate(TOO_WIDE)


def faults(page, clinic, name, sizes, directions=("ltr", "rtl")):
    """Return what is wrong with a place, by direction and size."""
    look_as(page, (sizes[0], "light"))
    PLACES[name](page, clinic)
    found = {} if name in IN_ENGLISH else {"English": english_words(page, clinic)}
    for direction in directions:
        page.evaluate(TURN, direction)
        for size in sizes:
            if size != TELEPHONE or name not in NOT_HERE:
                look_as(page, (size, "light"))
                found[direction, size] = overflows(page)
    return {cell: words for cell, words in found.items() if words}


def test_pages_of_daily_work_in_the_pseudo_language_on_a_telephone(page, clinic):
    found = {}
    for name in SHORT:
        found[name] = faults(page, clinic, name, [TELEPHONE])
        put_back(clinic)
    assert {name: words for name, words in found.items() if words} == {}


@pytest.mark.long
@pytest.mark.parametrize("name", PLACES)
def test_every_place_in_the_pseudo_language(page, clinic, name):
    assert faults(page, clinic, name, SIZES) == {}
