"""axe-core finds no violation on any page in any state, and decides the contrast of every text.

Each page is looked at in one size and theme here, and by `make browser` in all of them and in every state. The same
visit looks for what a finger misses, what Tab does not come to, what is cut off at 200 %, and what moves although the
person has asked for reduced motion. That all this is found is tried on a page that is broken.
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
MOVING = ("calibrate, runs", "drive, over")  # later states in which most would move
VISITED = {name: open_place for name, open_place in PLACES.items() if ", " not in name or name in MOVING}
# The addresses that the application itself knows: pages, and those below Drive and Review.
KNOWN = """async () => {
  const [{ PAGES }, { BELOW }, { OWN_PAGES }] = await Promise.all(
    ["shell/pages", "pages/drive/drive", "pages/review/review"].map((name) => import(`/js/${name}.js`)));
  const below = [...Object.keys(BELOW).map((one) => `drive/${one}`), ...OWN_PAGES.map((one) => `review/${one}`)];
  return [...Object.keys(PAGES), ...below];
}"""

# What the page has loaded, and the page itself.
LOADED = """() => [...performance.getEntriesByType("navigation"), ...performance.getEntriesByType("resource")]
  .map(({ name }) => name)"""

BROKEN = """<!doctype html><html lang="en"><title>A page</title><main><h1>A page</h1>
<p style="color:#999;background:#fff">Grey on white</p>
<p style="background:linear-gradient(#fff,#eee)">On a gradient</p>
<button style="width:44px;height:44px"></button>
<svg width="200" height="120"><rect width="200" height="120" fill="#eee"/>
<text id="faint" x="20" y="40" fill="#bbb">faint</text><text id="clear" x="20" y="80" fill="#222">clear</text></svg>
</main></html>"""


def address_of(url):
    """Return the address of a page without the numbers in it."""
    return "/".join(part for part in urlsplit(url).fragment.split("/") if part and not part.isdigit())


def path_of(url):
    """Return the path of a request without the version of the pages that stands in it."""
    return re.sub(r"^/v-[0-9a-f]+-[a-z]+", "", urlsplit(url).path)


def documents_and_pages():
    """Return the paths of all HTML documents, and of the module of each page."""
    folder = ROOT / PAGES
    pages = [place for place in (folder / "js" / "pages").iterdir() if place.is_dir()]
    documents = {f"/{file.name}" for file in folder.glob("*.html")}
    return documents | {f"/js/pages/{one.name}/{one.name}.js" for one in pages}


def test_what_is_wrong_is_found_and_what_is_right_is_not(browser):
    page = browser.new_page()
    page.set_content(BROKEN)
    found = {(one.kind, one.rule, one.target) for one in findings(page)}
    assert found == {
        ("violation", "color-contrast", "p:nth-child(2)"),
        ("undecided", "color-contrast", "p:nth-child(3)"),
        ("violation", "button-name", "button"),
        ("violation", "color-contrast", "#faint"),
    }


def test_an_id_that_is_shown_for_its_words_is_found(browser):
    page = browser.new_page()
    page.set_content(
        "<p>Left-hand <b>review-end-nothing</b></p><p>A lamp-shirt there</p><p aria-label='lamp-shirt'>x-y</p>"
    )
    assert shown_ids(page) == ["review-end-nothing", "lamp-shirt"]
    page.context.close()


def test_what_moves_is_found(page, clinic):
    page.emulate_media(reduced_motion="no-preference")
    PLACES["shirt"](page, clinic)
    assert moving_parts(page) != []


def test_one_size_and_theme_of_every_page(page, clinic):
    found = {}
    # The frames of "/" and of "/docs/", and one that shows nothing: pictures of a camera are read in it.
    addresses, loaded = set(), {"/index.html", "/docs.html", "/camera.html"}
    page.emulate_media(reduced_motion="reduce")
    for number, (name, open_place) in enumerate(VISITED.items()):
        cells = cells_of(name)
        cell = cells[number % len(cells)]
        look_as(page, cell, settle=0)
        open_place(page, clinic)
        page.wait_for_timeout(200)
        loaded |= {path_of(url) for url in page.evaluate(LOADED)}
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
    assert {cell: words for cell, words in found.items() if words} == {}
