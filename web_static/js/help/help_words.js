/** The texts of the help, which is loaded when somebody asks for it. */
import { catalogue } from "../words.js";
import messages from "../../words/help.ftl.js";

export const { t, hasText } = catalogue(messages);

/**
 * The name of the help of a place: that of the page below a page where there is one ("drive.chair"), else the page's.
 * @param {{page: string, rest: string[]}} route
 */
export function helpName({ page, rest }) {
  const below = `${page}.${rest[0]}`;
  return pageWords(below) ? below : page;
}

/** The title and the three sentences of a page; null for a page without help. @param {string} page */
export function pageWords(page) {
  const ids = ["title", "1", "2", "3"].map((part) => `help-${page}-${part}`);
  if (!ids.every(hasText)) return null;
  const [title, ...sentences] = ids.map((id) => t(id));
  return { title, sentences };
}

/** @type {Promise<unknown> | null} */
let styles = null;

/** Load the styles of the help, once; return when they apply, so that nothing is shown without them. */
export function loadStyles() {
  return (styles ??= new Promise((resolve) => {
    const link = document.createElement("link");
    link.rel = "stylesheet";
    link.href = "css/shell/help.css";
    link.onload = link.onerror = resolve;
    document.head.append(link);
  }));
}
