"""Uses a page by keyboard alone: Tab comes to a control, whose focus is seen; a key uses it."""

from playwright.sync_api import expect

ROUNDS, TABS = 20, 6  # so many Tabs a round: more often than that nobody presses it
# What has the focus, as a screen reader calls it: its own label, its field's label, or its words.
WORDS = """(one) => (one.getAttribute("aria-label") ?? one.labels?.[0]?.textContent ?? one.textContent)
  .trim().replaceAll(/\\s+/g, " ")"""
FOCUSED = f"""() => {{
  const one = document.activeElement;
  return !one || one === document.body ? "" : ({WORDS})(one);
}}"""
# Whether there is something of this name to come to: a page may be on its way there.
THERE = f"""(name) => [...document.querySelectorAll("a, button, input, select, textarea, summary, [tabindex]")]
  .some((one) => one.checkVisibility() && ({WORDS})(one).includes(name))"""
# Lets Tab go on until what has this name has the focus, so that it can be pressed without a look after each time.
HOLD = f"""(name) => {{
  const words = {WORDS}, passed = [];
  const hold = (event) => {{
    if (event.key !== "Tab") return;
    const now = document.activeElement ?? document.body;
    if (passed.push(now === document.body ? "" : words(now)) === 1 || now === document.body) return;
    if (!words(now).includes(name)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
  }};
  window.addEventListener("keydown", hold, true);
  window.endHold = () => {{
    window.removeEventListener("keydown", hold, true);
    return passed;
  }};
}}"""
SEEN = """() => {
  const one = document.activeElement.closest("label") ?? document.activeElement;
  const style = getComputedStyle(one);
  const box = one.getBoundingClientRect();
  return box.bottom > 0 && box.top < innerHeight && (style.outlineStyle !== "none" || one.localName === "g"
    || getComputedStyle(document.activeElement).outlineStyle !== "none");
}"""


def focused(page):
    """Return what has the focus, as a screen reader calls it; empty when nothing has."""
    return page.evaluate(FOCUSED)


def tab_to(page, name, key="Tab"):
    """Press Tab until the control of this name, which the page may be about to show, has the focus, which is seen."""
    page.wait_for_function(THERE, arg=name)
    page.evaluate(HOLD, name)
    *held, last = key.split("+")
    for one in held:
        page.keyboard.down(one)
    for _ in range(ROUNDS):
        for _ in range(TABS):
            page.keyboard.down(last)  # as a key that is held: half as many messages as for presses
        if name in focused(page):
            break
    for one in (last, *held):
        page.keyboard.up(one)
    passed = page.evaluate("() => window.endHold()")
    assert name in focused(page), f"Tab does not come to {name!r}, but to {passed}"
    page.wait_for_function(SEEN)  # what comes late above it may push it out of view for a moment


def press(page, name, key="Enter"):
    """Come to the control of this name by Tab, and press a key on it."""
    tab_to(page, name)
    page.keyboard.press(key)


def opens_and_gives_back(page, opener, field, closer="Cancel"):
    """Open what takes the focus into a field of this name, and close it: the focus is back where it was."""
    press(page, opener)
    page.wait_for_function(f"(name) => ({FOCUSED})().includes(name)", arg=field)
    press(page, closer)
    assert opener in focused(page)


def heading(page, name):
    """Return the expectation of the first heading of this name."""
    return expect(page.get_by_role("heading", name=name).first)
