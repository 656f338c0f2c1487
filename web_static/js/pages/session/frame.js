/**
 * What the pages of the records have in common: the links below each of them, and how a session stands.
 * @import { ComponentChild } from "../../../vendor/preact/preact.js"
 */
import { drawFoot, drawPage, h } from "../../preact.js";
import { t } from "../../texts.js";

/**
 * Show a page with links below it.
 * @param {HTMLElement} root @param {ComponentChild} page
 * @param {Record<string, string>} links their words by address
 */
export function drawWithLinks(root, page, links) {
  drawPage(root, page, "body session-record");
  const buttons = Object.entries(links).map(([href, words]) => h("a", { key: href, class: "btn", href }, words));
  drawFoot(root, [h("span", { class: "grow" }), buttons]);
}

/** How a session stands, as a tag. @param {{session: {ended: string | null, sign_off: unknown}}} tag */
export function StateTag({ session: { ended, sign_off: signed } }) {
  const state = signed ? "signed" : ended ? "ended" : "open";
  return h("span", { class: `tag${state === "signed" ? "" : " calm"}` }, t(`record-state-${state}`));
}
