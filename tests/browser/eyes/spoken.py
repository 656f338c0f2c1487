"""What a screen reader would say: the words that come into live regions, and how urgently."""

from collections.abc import Callable
from typing import Any

# Collects what live regions say: the text that is added to one, with how urgently. A region within another one that is
# "off" is silent, and so is one that nobody sees.
LISTEN = """() => {
  const LIVE = { status: "polite", alert: "assertive", log: "polite", timer: "off", output: "polite" };
  const urgency = (node) => {
    for (let one = node.nodeType === 1 ? node : node.parentElement; one; one = one.parentElement) {
      const live = one.getAttribute("aria-live") ?? LIVE[one.getAttribute("role") ?? one.localName];
      if (live) return live;
    }
    return "off";
  };
  window.said = [];
  const collect = (node) => {
    const words = node.textContent.trim().replaceAll(/\\s+/g, " ");
    const live = urgency(node);
    const element = node.nodeType === 1 ? node : node.parentElement;
    const isShown = element?.checkVisibility() && !element.closest("[inert]");
    if (words && live !== "off" && isShown) window.said.push([live, words]);
  };
  new MutationObserver((changes) => {
    for (const { type, target, addedNodes } of changes) {
      if (type === "characterData") collect(target);
      else for (const node of addedNodes) collect(node);
    }
  }).observe(document.body, { childList: true, subtree: true, characterData: true });
}"""
QUIET = 1000  # ms in which nothing more may be said
HEARD = "(words) => window.said.some(([, row]) => row.includes(words))"


def said(page: Any) -> Any:
    """Return what was said since the last look, with its urgency."""
    return page.evaluate("() => window.said.splice(0)")


def said_after(page: Any, change: Callable[[], Any], words: str = "") -> list[list[str]]:
    """Return what is said after a change, with its urgency: up to these words, and for a while from then on."""
    said(page)
    change()
    if words:
        page.wait_for_function(HEARD, arg=words)
    page.wait_for_timeout(QUIET)
    return list(said(page))


def with_words(rows: Any, words: str) -> list[str]:
    """Return how urgently these words were said, once for each time."""
    return [live for live, row in rows if words in row]
