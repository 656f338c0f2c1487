/**
 * Pages below the Drive page: which chair, and the patient's screen.
 * @import { App } from "../../main.js"
 * @import { VNode } from "../../preact.js"
 */
import { drawFoot, drawPage, h } from "../../preact.js";
import { t } from "../../texts.js";
import { PatientScreenCard, screenStore } from "../../widgets/patient_screen_card.js";
import { ChairChoice } from "./chair_choice.js";

/** @param {App} app @param {HTMLElement} root @param {string[]} task to go back to @param {AbortSignal} left */
export async function showChairs(app, root, task, left) {
  const first = await app.api.get("/chairs");
  if (!left.aborted) showBelow(root, "chair", h(ChairChoice, { app, first }), task);
}

/** @param {App} app @param {HTMLElement} root @param {string[]} task to go back to @param {AbortSignal} left */
export async function showScreen(app, root, task, left) {
  const store = await screenStore(app, left);
  if (!left.aborted) showBelow(root, "screen", h(PatientScreenCard, { store, isPage: true }), task);
}

/** @param {HTMLElement} root @param {"chair" | "screen"} name @param {VNode<any>} card @param {string[]} task */
function showBelow(root, name, card, task) {
  const back = ["#/drive", ...(task.length ? ["task", ...task] : [])].join("/");
  drawPage(root, [
    h("h1", { tabindex: -1 }, t(`drive-place-${name}`)),
    h("p", { class: "lead" }, t(`drive-place-${name}-lead`)),
    card,
  ]);
  drawFoot(root, [h("span", { class: "grow" }), h("a", { class: "btn go", href: back }, t("drive-done"))]);
}
