/** Pages below the Drive page: which chair, and the patient's screen. */
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { patientScreenCard } from "../../widgets/patient_screen_card.js";
import { chairChoice } from "./chair_choice.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {string[]} task to go back to @param {AbortSignal} signal */
export async function showChairs(app, root, task, signal) {
  const chairs = await app.api.get("/chairs");
  if (!signal.aborted) showBelow(root, "chair", chairChoice(app, chairs), task);
}

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {string[]} task to go back to @param {AbortSignal} signal */
export async function showScreen(app, root, task, signal) {
  const card = await patientScreenCard(app, signal, { isPage: true });
  if (!signal.aborted) showBelow(root, "screen", card, task);
}

/** @param {HTMLElement} root @param {"chair" | "screen"} name @param {HTMLElement} card @param {string[]} task */
function showBelow(root, name, card, task) {
  const back = ["#/drive", ...(task.length ? ["task", ...task] : [])].join("/");
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t(`drive-place-${name}`)),
      h("p", { class: "lead" }, t(`drive-place-${name}-lead`)),
      card,
    ),
    h("div", { class: "foot" }, h("span", { class: "grow" }), h("a", { class: "btn go", href: back }, t("drive-done"))),
  );
}
