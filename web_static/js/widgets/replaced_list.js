/**
 * What was replaced in the last 30 days, each with a button that puts it back under a free name.
 * @import { ReplacedView } from "types/api"
 */
import { Fragment, h, render, signal } from "../preact.js";
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { day } from "./format.js";

/**
 * @param {import("../main.js").App} app
 * @param {string[]} kinds of those that are listed: file, model, floorplan
 * @param {() => unknown} onBack called after a file was put back
 * @returns {{element: HTMLElement, show: () => Promise<void>}} hidden while there is nothing
 */
export function replacedList(app, kinds, onBack) {
  const list = signal(/** @type {ReplacedView[]} */ ([]));
  const element = document.createElement("details");
  const show = async () => {
    list.value = (await app.api.get("/replaced")).filter(({ kind }) => kinds.includes(kind));
    element.hidden = !list.value.length;
  };
  /** @param {ReplacedView} one */
  const putBack = (one) =>
    app.toasts.attempt(async () => {
      const { name } = await app.api.post(`/replaced/${one.kind}/${encodeURIComponent(one.id)}/restore`);
      app.toasts.show(t("replaced-back", { name }));
      await onBack();
      await show();
    });
  const Rows = () =>
    h(
      Fragment,
      {},
      h("summary", {}, t("replaced-title", { days: REFERENCE.numbers.replaced_days })),
      h(
        "div",
        { class: "plan-rows" },
        list.value.map((one) => h(Row, { key: `${one.kind} ${one.id}`, one, onPutBack: () => putBack(one) })),
      ),
    );
  element.hidden = true;
  render(h(Rows, {}), element);
  app.toasts.attempt(show);
  return { element, show };
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
        onClick: onPutBack,
      },
      t("replaced-put-back"),
    ),
  );
}
