"""axe-core finds no violation on any page in any state, and decides the contrast of every text.

Each place is looked at in one size and theme here, and in all of them by `make browser`.
"""

import pytest
from browser.eyes.axe import cells_of, findings, look_as
from browser.eyes.places import PLACES, put_back

pytestmark = [pytest.mark.browser, pytest.mark.timeout(600)]


def test_one_size_and_theme_of_every_page(page, clinic):
    found = {}
    for number, (name, open_place) in enumerate(PLACES.items()):
        cells = cells_of(name)
        cell = cells[number % len(cells)]
        look_as(page, cell)
        open_place(page, clinic)
        page.wait_for_timeout(200)
        found[name, *cell] = [str(one) for one in findings(page)]
        put_back(clinic)
    assert len(found) >= 40
    assert {cell: words for cell, words in found.items() if words} == {}


@pytest.mark.long
@pytest.mark.parametrize("name", PLACES)
def test_every_size_and_theme(page, clinic, name):
    PLACES[name](page, clinic)
    found = {}
    for cell in cells_of(name):
        look_as(page, cell)
        found[cell] = [str(one) for one in findings(page)]
    put_back(clinic)
    assert {cell: words for cell, words in found.items() if words} == {}
