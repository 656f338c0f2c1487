/** A drive of the real chair that is over: how far, how long, how it ended. */
import { drawFoot, drawPage, Fragment, h } from "../../preact.js";
import { hasText, t } from "../../texts.js";
import { clock, moment, number } from "../../widgets/format.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {number} id @param {AbortSignal} left */
export async function showDriveSummary(app, root, id, left) {
  const patient = app.session?.patient;
  const drives = patient ? await app.api.get(`/drives?patient=${patient.id}`) : [];
  if (left.aborted) return;
  const drive = drives.find((one) => one.id === id);
  drawPage(
    root,
    h(
      Fragment,
      {},
      h("h1", { tabindex: -1 }, t("driven-title")),
      h("p", { class: "lead" }, drive ? moment(drive.started) : t("driven-gone")),
      drive && figures(drive),
      drive && h("p", { class: "quiet small" }, t("over-source", { source: drive.source.description })),
      drive && h("p", { class: "quiet small fingerprint" }, t("driven-hash", { hash: drive.hash.slice(0, 8) })),
    ),
  );
  drawFoot(
    root,
    h(
      Fragment,
      {},
      h("span", { class: "grow" }),
      h("a", { class: "btn go", href: "#/drive/chair" }, t("driven-again")),
    ),
  );
}

/** @param {import("types/api").DriveView} drive */
function figures({ distance, started, ended, end }) {
  const time = ended ? (Date.parse(ended) - Date.parse(started)) / 1000 : null;
  const how = `driven-end-${end}`;
  return h(
    "div",
    { class: "large-figures" },
    figure("driven-distance", h("div", { class: "big" }, number(distance, 1), " ", h("small", {}, "m"))),
    figure("driven-time", h("div", { class: "big" }, time === null ? "–" : clock(time))),
    figure("driven-end", h("p", { class: "how-ended" }, hasText(how) ? t(how) : end)),
  );
}

/** @param {string} title key of a text @param {import("../../preact.js").ComponentChildren} value */
function figure(title, value) {
  return h("section", { class: "card" }, h("h2", {}, t(title)), value);
}
