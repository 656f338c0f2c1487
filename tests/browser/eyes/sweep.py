"""What a person without a mouse, with a finger or with an enlarged page cannot use, on the page as it is now."""

import re
from typing import Any

from browser.script import script
from web_static.messages import ids_of_language

# A link within a sentence is a part of the text; a box beside words is touched by its words too.
SMALL = script("small_targets")

# Notes everything that gets the focus: whether the focus is seen, and whether something lies over it. Of radio buttons
# of one name, Tab comes to one; the arrow keys come to the others.
BEGIN = script("begin_sweep")
SWEPT, END = "() => window.isSwept()", "() => window.endSweep()"
MOST_ROUNDS = 3  # a field for a day has a stop for each of its parts, and what scrolls has one, too

# In a browser of 1280 x 800 pixels that enlarges by 2.
ENLARGED = {"width": 640, "height": 400}
CHARTS_SETTLE = 600  # ms until charts have followed the window
LOST = script("lost")

# What moves after everything that opens was turned over, and every switch was pressed.
MOVES = script("moving_parts")

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


def small_targets(page: Any, within: str = "body") -> list[str]:
    """Return what a finger misses: controls with less than 44 px of touch area, within what a selector finds."""
    return list(page.evaluate(SMALL, within))


def keyboard_faults(page: Any) -> list[str]:
    """Hold Tab through the whole page; return what it does not come to, where it goes back, and unseen focus."""
    count = page.evaluate(BEGIN)
    for _ in range(MOST_ROUNDS):
        for _ in range(count):
            page.keyboard.down("Tab")  # again and again, as a key that is held: half as many messages as for presses
        if page.evaluate(SWEPT):
            break
    page.keyboard.up("Tab")
    return list(page.evaluate(END))


def lost(page: Any) -> list[str]:
    """Return what of the page as it is cannot be seen or reached."""
    return list(page.evaluate(LOST))


def lost_when_enlarged(page: Any) -> list[str]:
    """Return what is lost at 200 %: what cannot be reached, is cut off or covered, and pages that scroll sideways."""
    page.set_viewport_size(ENLARGED)
    if lost(page):
        page.wait_for_timeout(CHARTS_SETTLE)
    return lost(page)


def moving_parts(page: Any) -> list[str]:
    """Return what moves, or glides from one state to the next, after everything that opens was turned over."""
    return list(page.evaluate(MOVES))
