/** A list of facts: what it is at the left, how it stands at the right. */
import { t } from "../texts.js";
import { h, write } from "./dom.js";

/**
 * `write` sets one fact by its key; a fact without words is hidden.
 * @param {string[]} keys texts that name the facts, in order
 */
export function facts(keys) {
  const rows = new Map(
    keys.map((key) => {
      const words = h("dd", { class: "number" });
      return [key, { words, element: h("div", { hidden: true }, h("dt", {}, t(key)), words) }];
    }),
  );
  const element = h(
    "dl",
    { class: "fact-list" },
    [...rows.values()].map((row) => row.element),
  );
  /** @param {string} key @param {string} words */
  const show = (key, words) => {
    const row = rows.get(key);
    if (!row) return;
    row.element.hidden = words === "";
    write(row.words, words);
  };
  return { element, write: show };
}
