/** A sentence with figures that count: a screen reader says it only when it says something else. */
import { h, useRef } from "../../preact.js";

/** @param {{words: string}} sentence */
export function Spoken({ words }) {
  const before = useRef("");
  const bare = words.replace(/\d+/g, "");
  const isNews = bare !== before.current;
  before.current = bare;
  return h("span", { "aria-live": isNews ? "polite" : "off" }, words);
}
