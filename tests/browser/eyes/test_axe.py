"""axe-core finds no violation on any page in any state, and decides the contrast of every text.

Each page is looked at in one size and theme here, and by `make browser` in all of them and in every state. The same
visit looks for what a finger misses, what Tab does not come to, what is cut off at 200 %, and what moves although the
person has asked for reduced motion.
"""

import re
from urllib.parse import urlsplit

import pytest
from browser.eyes.axe import cells_of, findings, look_as
from browser.eyes.places import PLACES, put_back
from browser.eyes.sweep import keyboard_faults, lost_when_enlarged, moving_parts, shown_ids, small_targets

from folders import ROOT

pytestmark = [pytest.mark.browser]

PAGES = "web_static"
FIRST_STATES = {name: open_place for name, open_place in PLACES.items() if ", " not in name}
# The addresses that the application itself knows: pages, and those below Drive and Review.
KNOWN = """async () => {
  const [{ PAGES }, { BELOW }, { OWN_PAGES }] = await Promise.all(
    ["shell/rail", "pages/drive/drive", "pages/review/review"].map((name) => import(`/js/${name}.js`)));
  return [...PAGES, ...Object.keys(BELOW).map((one) => `drive/${one}`), ...OWN_PAGES.map((one) => `review/${one}`)];
}"""


def address_of(url):
    """Return the address of a page without the numbers in it."""
    return "/".join(part for part in urlsplit(url).fragment.split("/") if part and not part.isdigit())


def path_of(url):
    """Return the path of a request without the version of the pages that stands in it."""
    return re.sub(r"^/v-[0-9a-f]+", "", urlsplit(url).path)


def documents_and_pages():
    """Return the paths of all HTML documents, and of the module of each page."""
    folder = ROOT / PAGES
    pages = [place for place in (folder / "js" / "pages").iterdir() if place.is_dir()]
    documents = {f"/{file.name}" for file in folder.glob("*.html")}
    return documents | {f"/js/pages/{one.name}/{one.name}.js" for one in pages}


def test_one_size_and_theme_of_every_page(page, clinic):
    found = {}
    addresses, loaded = set(), {"/index.html", "/docs.html"}  # the frames of "/" and of "/docs/"
    page.on("request", lambda request: loaded.add(path_of(request.url)))
    page.emulate_media(reduced_motion="reduce")
    for number, (name, open_place) in enumerate(FIRST_STATES.items()):
        cells = cells_of(name)
        cell = cells[number % len(cells)]
        look_as(page, cell)
        open_place(page, clinic)
        page.wait_for_timeout(200)
        found[name, *cell] = [str(one) for one in findings(page)] + small_targets(page) + keyboard_faults(page)
        found[name, "ids"] = shown_ids(page)
        found[name, "200 %"] = lost_when_enlarged(page)
        found[name, "motion"] = moving_parts(page)
        address = address_of(page.url)
        addresses |= {address, address.split("/")[0]}
        put_back(clinic)
    page.emulate_media(reduced_motion="no-preference")
    assert {cell: words for cell, words in found.items() if words} == {}
    PLACES["patients"](page, clinic)
    assert set(page.evaluate(KNOWN)) <= addresses  # else: a line in PLACES is missing
    assert documents_and_pages() <= loaded  # else: there is a page that no place opens


@pytest.mark.long
@pytest.mark.parametrize("name", PLACES)
def test_every_size_and_theme(page, clinic, name):
    PLACES[name](page, clinic)
    found = {}
    for cell in cells_of(name):
        look_as(page, cell)
        found[cell] = [str(one) for one in findings(page)] + small_targets(page)
    found["ids"] = shown_ids(page)
    found["keyboard"] = keyboard_faults(page)
    found["200 %"] = lost_when_enlarged(page)
    put_back(clinic)
    assert {cell: words for cell, words in found.items() if words} == {}
