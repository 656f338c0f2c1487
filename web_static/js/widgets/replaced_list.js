/**
 * What was replaced in the last 30 days, each with a button that puts it back under a free name.
 * @import { ReplacedView } from "types/api"
 */
import { passFocus } from "../focus.js";
import { h, signal } from "../preact.js";
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { day } from "./format.js";

/**
 * The list, hidden while there is nothing, and what reads it again.
 * @param {import("../main.js").App} app
 * @param {string[]} kinds of those that are listed: file, model, floorplan
 * @param {() => unknown} onBack called after a file was put back
 */
export function replacedList(app, kinds, onBack) {
  const list = signal(/** @type {ReplacedView[]} */ ([]));
  const read = async () => {
    list.value = (await app.api.get("/replaced")).filter(({ kind }) => kinds.includes(kind));
  };
  /** @param {ReplacedView} one */
  const putBack = (one) =>
    app.toasts.attempt(async () => {
      const { name } = await app.api.post(`/replaced/${one.kind}/${encodeURIComponent(one.id)}/restore`);
      app.toasts.show(t("replaced-back", { name }));
      await onBack();
      await read();
    });
  const ReplacedList = () =>
    h(
      "details",
      { hidden: !list.value.length },
      h("summary", {}, t("replaced-title", { days: REFERENCE.numbers.replaced_days })),
      h(
        "div",
        { class: "plan-rows" },
        list.value.map((one) => h(Row, { key: `${one.kind} ${one.id}`, one, onPutBack: () => putBack(one) })),
      ),
    );
  app.toasts.attempt(read);
  return { ReplacedList, read };
}

/** @param {{one: ReplacedView, onPutBack: () => void}} row */
function Row({ one: { name, replaced, until }, onPutBack }) {
  return h(
    "div",
    { class: "card plan-row" },
    h(
      "div",
      { class: "grow" },
      h("b", {}, name),
      h("span", { class: "quiet small" }, t("replaced-when", { day: day(replaced), until: day(until) })),
    ),
    h(
      "button",
      {
        type: "button",
        class: "btn small",
        "aria-label": t("replaced-put-back-label", { name }),
        ref: passFocus,
        onClick: onPutBack,
      },
      t("replaced-put-back"),
    ),
  );
}
