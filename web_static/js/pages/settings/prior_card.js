/**
 * Whether accepted calibrations help later patients to drive before they are calibrated themselves.
 * @import { PriorView } from "types/api"
 */
import { h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Toggle } from "../../widgets/fields.js";

/** @param {{app: import("../../main.js").App, first: PriorView, isOwner: boolean}} card first: what GET /clinic-prior answered */
export function PriorCard({ app, first, isOwner }) {
  const prior = useSignal(first);
  const { on, people, needed } = prior.value;
  const enough = people >= needed ? "enough" : "few";
  /** @param {boolean} isOn */
  const choose = (isOn) =>
    app.toasts.attempt(async () => void (prior.value = await app.api.put("/clinic-prior", { on: isOn })));
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("prior-title")),
    h("p", { class: "quiet small" }, t("prior-lead")),
    isOwner && h(Toggle, { label: t("prior-on"), on, onChange: choose }),
    h("p", { class: "small", role: "status" }, on ? t(`prior-${enough}`, { count: people, needed }) : t("prior-off")),
  );
}
