/**
 * Which chair: the virtual one, and how it feels; or a real one, which has a page of its own.
 * @import { ChairsView } from "types/api"
 * @typedef {ChairsView["dynamics"]} Dynamics
 */
import { h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Segments } from "../../widgets/fields.js";

/** @type {Dynamics[]} */
const FEELS = ["unicycle", "wheelchair"];

/** @param {{app: import("../../main.js").App, first: ChairsView}} card first: what GET /chairs answered */
export function ChairChoice({ app, first: { chairs, dynamics } }) {
  const isOwner = app.me?.role === "owner";
  const chosen = useSignal(dynamics);
  const inUse = useSignal(dynamics);
  /** @param {number | null} id null: the virtual chair */
  const choose = (id) => app.toasts.attempt(() => app.api.put("/chairs/chosen", { id, dynamics: chosen.value }));
  /** @param {string} feel */
  const setFeel = async (feel) => {
    const before = chosen.value;
    chosen.value = /** @type {Dynamics} */ (feel);
    if (!(await choose(null))) chosen.value = before;
    inUse.value = chosen.value;
  };
  /** @param {number} id */
  const go = async (id) => (await choose(id)) && app.go("#/drive/chair");
  const feels = FEELS.map((value) => ({ value, label: t(`which-feel-${value}`) }));
  return h(
    "section",
    { class: "card which" },
    h(
      "div",
      {},
      h(
        "div",
        { class: "spread" },
        h("h2", {}, t("which-virtual")),
        h(Segments, { label: t("which-feel"), options: feels, chosen: chosen.value, onChange: setFeel }),
      ),
      h("span", { class: "quiet small", role: "status" }, t(`which-feel-${inUse.value}-hint`)),
    ),
    h(
      "div",
      { class: "spread" },
      h("h2", {}, t("which-real")),
      chairs.map(({ id, name }) =>
        h("button", { key: id, type: "button", class: "btn", onClick: () => go(id) }, t("which-real-go", { name })),
      ),
      !chairs.length && h("span", { class: "quiet small" }, t(isOwner ? "which-none" : "which-none-ask")),
      !chairs.length && isOwner && h("a", { class: "btn bare", href: "#/settings" }, t("which-none-go")),
    ),
  );
}
