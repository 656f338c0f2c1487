/**
 * What was replaced in the last 30 days, each with a button that puts it back under a free name.
 * @import { ReplacedView } from "types/api"
 */
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { h, put } from "./dom.js";
import { day } from "./format.js";

/**
 * @param {import("../main.js").App} app
 * @param {string[]} kinds of those that are listed: file, model, floorplan
 * @param {() => unknown} onBack called after a file was put back
 * @returns {{element: HTMLElement, show: () => Promise<void>}} hidden while there is nothing
 */
export function replacedList(app, kinds, onBack) {
  const rows = h("div", { class: "plan-rows" });
  const element = h(
    "details",
    { hidden: true },
    h("summary", {}, t("replaced-title", { days: REFERENCE.numbers.replaced_days })),
    rows,
  );
  let shown = ""; // a list that is the same stays as it is, for whoever is about to tap in it
  const show = async () => {
    const list = (await app.api.get("/replaced")).filter(({ kind }) => kinds.includes(kind));
    const read = JSON.stringify(list);
    if (read === shown) return;
    shown = read;
    put(rows, list.map(row));
    element.hidden = !list.length;
  };
  /** @param {ReplacedView} one */
  const putBack = (one) =>
    app.toasts.attempt(async () => {
      const { name } = await app.api.post(`/replaced/${one.kind}/${encodeURIComponent(one.id)}/restore`);
      app.toasts.show(t("replaced-back", { name }));
      await onBack();
      await show();
    });
  /** @param {ReplacedView} one */
  const row = (one) =>
    h(
      "div",
      { class: "card plan-row" },
      h(
        "div",
        { class: "grow" },
        h("b", {}, one.name),
        h("span", { class: "quiet small" }, t("replaced-when", { day: day(one.replaced), until: day(one.until) })),
      ),
      h(
        "button",
        {
          type: "button",
          class: "btn small",
          "aria-label": t("replaced-put-back-label", { name: one.name }),
          onclick: () => putBack(one),
        },
        t("replaced-put-back"),
      ),
    );
  app.toasts.attempt(show);
  return { element, show };
}
