"""At 200 % and 400 % nothing is lost: no page scrolls sideways, Stop stays in view, every button can be reached.

A browser of 1280 x 800 pixels that enlarges by 2 lays out 640 x 400; one of 1280 x 1024 that enlarges by 4, 320 x 256.
"""

import pytest
from browser.eyes.axe import look_as
from browser.eyes.places import PLACES, put_back

pytestmark = [pytest.mark.browser, pytest.mark.long]

ZOOMS = {"200 %": (640, 400, 2), "400 %": (320, 256, 4)}
SHORT = (  # one place of each kind of page
    "sign_in", "patients, new", "shirt, lamp", "calibrate", "controls", "drive", "drive, stopped", "drive, over",
    "review", "review trial", "settings, paired", "plans", "people, invite", "log", "chair", "patient's screen",
    "review, warnings", "session compare, verdicts",
)  # fmt: skip
WITHOUT_STOP = ("stereo", "tablet", "patient's screen", "share link", "docs")  # pages that no clinician drives by
LOST = """() => {
  const lost = [];
  const name = (one) => `${one.tagName.toLowerCase()}.${String(one.getAttribute("class") ?? "").replaceAll(" ", ".")}`
    + ` "${(one.getAttribute("aria-label") ?? one.textContent).trim().slice(0, 40)}"`;
  const inside = ({ left, top, right, bottom }) =>
    left >= -1 && top >= -1 && right <= innerWidth + 1 && bottom <= innerHeight + 1 && right > left && bottom > top;
  if (document.documentElement.scrollWidth > innerWidth) lost.push("the window scrolls sideways");
  for (const one of document.querySelectorAll("main, .app, .card"))
    if (one.checkVisibility() && one.scrollWidth > one.clientWidth + 1 && getComputedStyle(one).overflowX !== "visible")
      lost.push(`scrolls sideways: ${name(one)}`);
  for (const one of document.querySelectorAll("main :is(button, a.btn, input:not(.unseen), select, h1, h2, p)")) {
    if (!one.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
    if (one.closest(".scroll-x, .unseen, [inert], [type=file], label.choice, .segments, label.switch")) continue;
    one.scrollIntoView({ block: "center", inline: "nearest", behavior: "instant" });
    const box = one.getBoundingClientRect();
    if (!box.width) continue;
    if (box.left < -1 || box.right > innerWidth + 1) lost.push(`beside the window: ${name(one)}`);
    if (!one.matches("button, a, input, select")) continue;
    const at = document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
    const card = at?.closest(".fault-card, .page-help, .question, .toast");
    if (card && !card.contains(one)) continue; // the card is answered or closed first, and then this is in view again
    const isHit = at && (one.contains(at) || at.contains(one) || at.closest("label")?.contains(one));
    if (!isHit && !one.disabled) lost.push(`covered: ${name(one)}${at ? ` by ${name(at)}` : ""}`);
  }
  const stop = document.getElementById("stop");
  if (stop && !inside(stop.firstElementChild.getBoundingClientRect())) lost.push("Stop is out of view");
  const head = document.querySelector(".head");
  const top = head?.getBoundingClientRect().bottom ?? 0;
  for (const toast of document.querySelectorAll(".toast"))
    if (toast.getBoundingClientRect().top < top) lost.push("a message under the header");
  const corner = stop?.getBoundingClientRect();
  if (corner && (corner.top > 1 || corner.right < innerWidth - 1)) lost.push("Stop is not in its corner");
  if (head && head.scrollHeight > head.clientHeight + 1) lost.push("the header stands over the page");
  return [stop ? "" : "there is no Stop", ...lost].filter(Boolean);
}"""


@pytest.fixture(params=ZOOMS)
def enlarged(request, browser, clinic):
    """Yield the owner's page, enlarged."""
    width, height, factor = ZOOMS[request.param]
    context = browser.new_context(
        storage_state=clinic.storage(), viewport={"width": width, "height": height}, device_scale_factor=factor
    )
    page = context.new_page()
    page.set_default_timeout(60_000)
    yield page
    context.close()


def losses(page, clinic, names):
    """Return what is lost, by place."""
    lost = {}
    for name in names:
        PLACES[name](page, clinic)
        page.wait_for_timeout(200)
        found = page.evaluate(LOST)
        if name.startswith(WITHOUT_STOP):
            found = [words for words in found if words != "there is no Stop"]
        if found:
            lost[name] = found
        put_back(clinic)
    return lost


def test_nothing_is_lost_in_any_state(enlarged, clinic):
    assert losses(enlarged, clinic, PLACES) == {}


@pytest.mark.parametrize("cell", [("768x1024", "light"), ("1280x800", "light"), ("390x844", "light")])
def test_no_state_scrolls_sideways(page, clinic, cell):
    look_as(page, cell)
    assert losses(page, clinic, SHORT) == {}
