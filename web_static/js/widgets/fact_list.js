/** A list of facts: what it is at the left, how it stands at the right, with a remark below. */
import { h } from "../preact.js";

/** @typedef {[name: string, value: import("../preact.js").ComponentChildren, remark?: string]} Fact */

/** @param {{facts: Fact[]}} list */
export function FactList({ facts }) {
  return h(
    "dl",
    { class: "fact-list" },
    facts.map(([name, value, remark]) =>
      h("div", { key: name }, h("dt", {}, name), h("dd", { class: "number" }, value, remark && h("small", {}, remark))),
    ),
  );
}
