/** Two trials side by side. */
import { compareTable } from "../parts/compare_table.js";
import { h, put } from "../parts/dom.js";
import { moment } from "../parts/format.js";
import { t } from "../texts.js";

/** @param {import("../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal, rest: [patient, , ...ids] }) {
  const trials = await Promise.all(ids.slice(0, 2).map((id) => app.api.get(`/trials/${id}`)));
  if (signal.aborted) return;
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("compare.title")),
      h("p", { class: "lead" }, trials.map((one) => `${t("compare.trial", one)}: ${moment(one.started)}`).join(" · ")),
      compareTable(trials),
    ),
    h(
      "div",
      { class: "foot" },
      h("span", { class: "grow" }),
      h("a", { class: "btn", href: `#/review/${patient}` }, t("review.back")),
    ),
  );
}
