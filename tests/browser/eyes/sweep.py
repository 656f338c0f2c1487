"""What a person without a mouse, with a finger or with an enlarged page cannot use, on the page as it is now."""

import re
from typing import Any

from web_static.messages import ids_of_language

# A link within a sentence is a part of the text; a box beside words is touched by its words too.
SMALL = """() => {
  const targets = "button, a[href], input:not([type=file]), select, textarea, summary, [role=slider]";
  const name = (one) => `${one.tagName.toLowerCase()}.${one.getAttribute("class") ?? ""} "${
    (one.getAttribute("aria-label") ?? one.textContent).trim().slice(0, 40)}"`;
  const isShown = (one) => one.checkVisibility({ visibilityProperty: true, opacityProperty: true });
  return [...document.querySelectorAll(targets)]
    .filter((one) => isShown(one) && !one.closest(".unseen"))
    .map((one) => one.closest("label") ?? one)
    .filter((one) => !(one.matches("a:not(.btn)") && one.closest("p, li, td")))
    .map((one) => [one, one.getBoundingClientRect()])
    .filter(([one, { width, height }]) => width && (height < 43.5 || (width < 43.5 && !one.matches("[role=slider]"))))
    .map(([one, { width, height }]) => `${Math.round(width)} x ${Math.round(height)} ${name(one)}`);
}"""

# Notes everything that gets the focus: whether the focus is seen, and whether something lies over it. Of radio buttons
# of one name, Tab comes to one; the arrow keys come to the others.
BEGIN = """() => {
  const name = (one) => `${one.tagName.toLowerCase()}.${one.getAttribute("class") ?? ""} "${
    (one.getAttribute("aria-label") ?? one.labels?.[0]?.textContent ?? one.textContent).trim().slice(0, 40)}"`;
  const every = "a[href], button, input, select, textarea, summary, iframe, [tabindex]";
  const groups = new Map();
  const wanted = [...document.querySelectorAll(every)].filter((one) => {
    if (!one.checkVisibility({ visibilityProperty: true }) || one.disabled || one.tabIndex < 0) return false;
    if (one.closest("[inert]") || one.localName === "iframe") return false;
    if (one.type !== "radio" || !one.name) return true;
    const key = `${one.name} ${one.form ? [...document.forms].indexOf(one.form) : ""}`;
    const group = groups.get(key) ?? [...document.querySelectorAll("input[type=radio]")]
      .filter((other) => other.name === one.name && other.form === one.form);
    groups.set(key, group);
    return one === (group.find((other) => other.checked) ?? group[0]);
  });
  const faults = wanted.filter((one) => one.tabIndex > 0).map((one) => `before its turn: ${name(one)}`);
  const reached = [];
  const isSeen = (one) => [one, one.closest("label"), one.nextElementSibling, one.querySelector("*")]
    .some((each) => {
      if (!each) return false;
      const { outlineStyle, outlineWidth } = getComputedStyle(each);
      return outlineStyle !== "none" && parseFloat(outlineWidth) > 0;
    }) || one.localName === "g";
  const isCovered = (one) => {
    const box = (one.closest("label") ?? one).getBoundingClientRect();
    const places = [0.5, 0.05, 0.95].map((part) => [box.left + part * box.width, box.top + part * box.height]);
    return !places.some(([x, y]) => {
      const at = document.elementFromPoint(x, y);
      const isPassing = at?.closest(".toast, .question"); // it goes away by itself, or is answered first
      return at && (isPassing || one.contains(at) || at.contains(one) || at.closest("label")?.contains(one));
    });
  };
  const listen = ({ target }) => {
    if (target === start || target.tabIndex < 0) return; // focused by the page itself: no stop of Tab
    reached.push(target);
    if (!isSeen(target)) faults.push(`its focus is not seen: ${name(target)}`);
    if (isCovered(target)) faults.push(`covered: ${name(target)}`);
  };
  document.addEventListener("focusin", listen, true);
  const start = document.createElement("span"); // Tab begins after the element that had the focus
  start.tabIndex = -1;
  document.body.prepend(start);
  start.focus();
  const unreached = () => wanted.filter((one) =>
    one.isConnected && one.checkVisibility() && !one.disabled && one.tabIndex >= 0 && !reached.includes(one));
  window.isSwept = () => unreached().length === 0;
  window.endSweep = () => {
    document.removeEventListener("focusin", listen, true);
    start.remove();
    for (const one of unreached()) faults.push(`Tab does not come to ${name(one)}`);
    const places = reached.map((one) => wanted.indexOf(one)).filter((place) => place >= 0);
    places.forEach((place, i) => {
      if (i && place <= places[i - 1] && place) faults.push(`Tab goes back to ${name(wanted[place])}`);
    });
    return [...new Set(faults)];
  };
  return wanted.length;
}"""
SWEPT, END = "() => window.isSwept()", "() => window.endSweep()"
MOST_ROUNDS = 3  # a field for a day has a stop for each of its parts, and what scrolls has one, too

# In a browser of 1280 x 800 pixels that enlarges by 2.
ENLARGED = {"width": 640, "height": 400}
CHARTS_SETTLE = 600  # ms until charts have followed the window
CUT_OFF = """() => {
  const lost = [];
  if (document.documentElement.scrollWidth > innerWidth) lost.push("the window scrolls sideways");
  for (const one of document.querySelectorAll("main, .app"))
    if (one.checkVisibility() && one.scrollWidth > one.clientWidth + 1 && getComputedStyle(one).overflowX !== "visible")
      lost.push("the page scrolls sideways");
  for (const one of document.querySelectorAll("main .btn.go")) {
    if (!one.checkVisibility({ visibilityProperty: true })) continue;
    one.scrollIntoView({ block: "center", inline: "nearest", behavior: "instant" });
    const box = one.getBoundingClientRect();
    const isIn = box.left >= -1 && box.right <= innerWidth + 1 && box.top >= -1 && box.bottom <= innerHeight + 1;
    const isCut = one.scrollWidth > one.clientWidth + 1 || one.scrollHeight > one.clientHeight + 1;
    const at = document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
    const isOver = at?.closest(".fault-card, .page-help, .question, .toast"); // answered first
    if (!isIn || isCut || !(one.contains(at) || isOver || one.closest("[inert]")))
      lost.push(`the main button is cut off or covered: ${one.textContent.trim()}`);
  }
  return lost;
}"""

# What moves after everything that opens was turned over, and every switch was pressed.
MOVES = """() => {
  document.querySelectorAll("details").forEach((one) => (one.open = !one.open));
  document.querySelectorAll(".switch input").forEach((one) => (one.checked = !one.checked));
  document.querySelectorAll(".tune").forEach((one) => one.setAttribute("aria-expanded", "true"));
  getComputedStyle(document.body).opacity;
  return document.getAnimations({ subtree: true }).map(({ effect, animationName, transitionProperty }) =>
    `${animationName ?? transitionProperty} of ${effect.target.className} ${effect.pseudoElement ?? ""}`);
}"""

# Every text of the page, shown or not, and what stands for one.
TEXTS = """() => {
  const texts = new Set();
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) texts.add(walker.currentNode.data.trim());
  for (const name of ["aria-label", "title", "placeholder", "alt"])
    for (const one of document.querySelectorAll(`[${name}]`)) texts.add(one.getAttribute(name).trim());
  return [document.title, ...texts];
}"""
ID = re.compile(r"([a-z]\w*)-\w[\w+-]*")
WORDS_OF_THE_LOG = {"sign-in"}


def shown_ids(page: Any) -> list[str]:
    """Return the texts that are the id of a message instead of its words."""
    beginnings = {name.split("-")[0] for names in ids_of_language().values() for name in names}
    alike = ((text, ID.fullmatch(text)) for text in page.evaluate(TEXTS))
    return [text for text, found in alike if found and found[1] in beginnings and text not in WORDS_OF_THE_LOG]


def small_targets(page: Any) -> list[str]:
    """Return what a finger misses: controls with less than 44 px of touch area."""
    return list(page.evaluate(SMALL))


def keyboard_faults(page: Any) -> list[str]:
    """Press Tab through the whole page; return what it does not come to, where it goes back, and unseen focus."""
    count = page.evaluate(BEGIN)
    for _ in range(MOST_ROUNDS):
        for _ in range(count):
            page.keyboard.press("Tab")
        if page.evaluate(SWEPT):
            break
    return list(page.evaluate(END))


def lost_when_enlarged(page: Any) -> list[str]:
    """Return what is lost at 200 %: main buttons that are cut off or covered, and pages that scroll sideways."""
    page.set_viewport_size(ENLARGED)
    if page.evaluate(CUT_OFF):
        page.wait_for_timeout(CHARTS_SETTLE)
    return list(page.evaluate(CUT_OFF))


def moving_parts(page: Any) -> list[str]:
    """Return what moves, or glides from one state to the next, after everything that opens was turned over."""
    return list(page.evaluate(MOVES))
