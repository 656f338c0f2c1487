/**
 * A question about a plan that is not saved: it takes the focus; Escape answers that nothing is done.
 * @import { ComponentChildren } from "../preact.js"
 */
import { h, useLayoutEffect, useRef } from "../preact.js";

/**
 * @param {object} card
 * @param {object} card.asked what is asked, another object each time @param {string} card.id of the title
 * @param {string} card.title @param {string} card.lead @param {() => void} card.onClose
 * @param {ComponentChildren} [card.children] the answers
 */
export function AskCard({ asked, id, title, lead, onClose, children }) {
  const card = useRef(/** @type {HTMLDivElement | null} */ (null));
  useLayoutEffect(() => {
    card.current?.scrollIntoView({ block: "nearest" });
    card.current?.focus();
  }, [asked]);
  return h(
    "div",
    {
      class: "card ask",
      role: "alertdialog",
      "aria-labelledby": id,
      tabindex: -1,
      ref: card,
      onKeyDown: (/** @type {KeyboardEvent} */ { key }) => void (key === "Escape" && onClose()),
    },
    h("h2", { id }, title),
    h("p", {}, lead),
    h("div", { class: "spread" }, children),
  );
}

/** @param {{words: string, kind?: string, onClick: () => unknown}} answer kind: classes of the button */
export function Answer({ words, kind = "btn", onClick }) {
  return h("button", { type: "button", class: kind, onClick }, words);
}
