/**
 * Whether accepted calibrations help later patients to drive before they are calibrated themselves.
 * @import { PriorView } from "types/api"
 */
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";
import { toggle } from "../../widgets/fields.js";

/** @param {import("../../main.js").App} app @param {PriorView} prior what GET /clinic-prior answered @param {boolean} isOwner */
export function priorCard(app, prior, isOwner) {
  const state = h("p", { class: "small", role: "status" });
  /** @param {PriorView} now */
  const show = ({ on, people, needed }) => {
    const enough = people >= needed ? "enough" : "few";
    write(state, on ? t(`prior-${enough}`, { count: people, needed }) : t("prior-off"));
  };
  /** @param {boolean} on */
  const choose = (on) => app.toasts.attempt(async () => show(await app.api.put("/clinic-prior", { on })));
  show(prior);
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("prior-title")),
    h("p", { class: "quiet small" }, t("prior-lead")),
    isOwner && toggle(t("prior-on"), prior.on, choose),
    state,
  );
}
