/** Two rows of a list that are ticked to be compared. */
import { h } from "../preact.js";

/**
 * The rows that are ticked after a change of one; a third takes the place of the first.
 * @template {{id: number}} Row @param {Row[]} pair at most two @param {Row} row @param {boolean} isChosen
 */
export function withChoice(pair, row, isChosen) {
  const others = pair.filter(({ id }) => id !== row.id);
  return isChosen ? [...others, row].slice(-2) : others;
}

/**
 * The link that compares both, and what is missing or chosen.
 * @param {{words: string, href: string | undefined, state: string}} link href: undefined until there are two
 */
export function PairLink({ words, href, state }) {
  return h(
    "div",
    { class: "spread compare-choice" },
    h("a", { class: "btn", href, "aria-disabled": !href || undefined }, words),
    h("span", { class: "quiet", role: "status" }, state),
  );
}
