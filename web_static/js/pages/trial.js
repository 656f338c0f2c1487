/** One trial of Review. */
import { h } from "../parts/dom.js";
import { readTrial, showTrialOver } from "../parts/trial_over.js";
import { t } from "../texts.js";

/** @param {import("../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal, rest: [patient, , id] }) {
  const read = await readTrial(app.api, id);
  if (signal.aborted) return;
  showTrialOver(app, root, read, () => [h("a", { class: "btn", href: `#/review/${patient}` }, t("review.back"))]);
}
