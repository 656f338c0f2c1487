/**
 * Which chair: the virtual one, and how it feels; or a real one, which has a page of its own.
 * @import { ChairsView } from "types/api"
 * @typedef {ChairsView["dynamics"]} Dynamics
 */
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";
import { segments } from "../../widgets/fields.js";

/** @type {Dynamics[]} */
const FEELS = ["unicycle", "wheelchair"];

/** @param {import("../../main.js").App} app @param {ChairsView} chairs what GET /chairs answered */
export function chairChoice(app, chairs) {
  const hint = h("span", { class: "quiet small", role: "status" }, t(`which-feel-${chairs.dynamics}-hint`));
  let dynamics = chairs.dynamics;
  /** @param {number | null} id null: the virtual chair */
  const choose = (id) => app.toasts.attempt(() => app.api.put("/chairs/chosen", { id, dynamics }));
  /** @param {Dynamics} wanted */
  const feel = async (wanted) => {
    const before = dynamics;
    dynamics = wanted;
    if (!(await choose(null))) {
      dynamics = before;
      for (const input of feels.querySelectorAll("input")) input.checked = input.value === before;
    }
    write(hint, t(`which-feel-${dynamics}-hint`));
  };
  const feels = segments(
    t("which-feel"),
    FEELS.map((value) => ({ value, label: t(`which-feel-${value}`) })),
    dynamics,
    feel,
  );
  /** @param {ChairsView["chairs"][number]} chair */
  const real = ({ id, name }) =>
    h(
      "button",
      { type: "button", class: "btn", onclick: async () => (await choose(id)) && app.go("#/drive/chair") },
      t("which-real-go", { name }),
    );
  const isOwner = app.me?.role === "owner";
  const none = [
    h("span", { class: "quiet small" }, t(isOwner ? "which-none" : "which-none-ask")),
    isOwner && h("a", { class: "btn bare", href: "#/settings" }, t("which-none-go")),
  ];
  return h(
    "section",
    { class: "card which" },
    h("div", {}, h("div", { class: "spread" }, h("h2", {}, t("which-virtual")), feels), hint),
    h("div", { class: "spread" }, h("h2", {}, t("which-real")), chairs.chairs.length ? chairs.chairs.map(real) : none),
  );
}
