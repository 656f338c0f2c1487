/**
 * The chairs that are paired: what they are called, where they are, what they may do; pair one, unpair one.
 * @import { ChairsView, NewChair, PairedView } from "types/api"
 * @typedef {ChairsView["chairs"][number]} Chair
 */
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { day, number } from "../../widgets/format.js";
import { icon } from "../../widgets/icons.js";
import { rowList } from "../../widgets/list.js";
import { pairForm } from "./pair_form.js";
import { pairedCard } from "../../widgets/one_time_key.js";

/** @param {import("../../main.js").App} app @param {ChairsView} chairs @param {boolean} isOwner @param {AbortSignal} signal */
export function chairsCard(app, chairs, isOwner, signal) {
  const list = rowList("paired-chairs");
  const below = h("div", {});
  /** @type {number | null} id of the chair that somebody is about to unpair */
  let unpairing = null;
  const draw = () =>
    list.show(
      chairs.chairs.map((chair) => row(chair)),
      h("p", { class: "quiet" }, t("chairs-none")),
    );
  /** @param {CustomEvent<string>} event */
  const readAgain = async ({ detail }) => {
    if (detail !== "equipment" && detail !== "everything") return;
    chairs = await app.api.get("/chairs").catch(() => chairs);
    draw();
  };
  /** @param {Chair | null} chair */
  const ask = (chair) => {
    unpairing = chair?.id ?? null;
    draw();
    /** @type {HTMLElement | null} */ (list.querySelector("[data-first]"))?.focus();
  };
  /** @param {Chair} chair */
  const unpair = async (chair) => {
    unpairing = null;
    await app.toasts.attempt(async () => {
      chairs = await app.api.remove(`/chairs/${chair.id}`);
      app.toasts.show(t("chairs-unpaired", { name: chair.name }));
    });
    draw();
  };
  /** @param {Chair} chair */
  const row = (chair) =>
    h(
      "div",
      { class: "paired-chair" },
      h(
        "div",
        { class: "row" },
        h(
          "div",
          { class: "grow" },
          h("b", {}, chair.name),
          " ",
          h("span", { class: "quiet" }, t("chairs-address", { host: chair.host, port: chair.port })),
          h("div", { class: "quiet small" }, factsOf(chair)),
        ),
        isOwner &&
          h(
            "button",
            {
              type: "button",
              class: "icon-button",
              "aria-label": t("chairs-unpair-label", { name: chair.name }),
              title: t("chairs-unpair"),
              onclick: () => ask(chair),
            },
            icon("bin", 22),
          ),
      ),
      unpairing === chair.id && confirmation(chair, unpair, () => ask(null)),
    );
  const offer = () =>
    put(
      below,
      isOwner && h("button", { type: "button", class: "btn", onclick: openForm }, icon("plus", 20), t("chairs-pair")),
    );
  const openForm = () => {
    put(below, pairForm(app, { onPaired: showKey, onClose: offer }));
    below.querySelector("input")?.focus();
  };
  /** @param {PairedView} answer @param {Required<NewChair>} chair */
  const showKey = (answer, chair) => {
    chairs = answer;
    draw();
    const card = pairedCard(app, answer, chair, offer);
    put(below, card);
    card.querySelector("h2")?.focus();
    card.scrollIntoView({ block: "nearest" });
  };
  app.live.addEventListener("changed", readAgain, { signal });
  draw();
  offer();
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("chairs-title")),
    h("p", { class: "quiet small" }, t("chairs-lead")),
    list,
    below,
  );
}

/** @param {Chair} chair */
function factsOf({ speeds, key_id: key, paired }) {
  const figures = { forward: number(speeds.forward, 2), reverse: number(speeds.reverse, 2), when: day(paired) };
  return `${t("chairs-facts", figures)} · ${t("chairs-key", { key })}`;
}

/** @param {Chair} chair @param {(chair: Chair) => void} onUnpair @param {() => void} onClose */
function confirmation(chair, onUnpair, onClose) {
  return h(
    "div",
    { class: "confirm", role: "group", "aria-label": t("chairs-unpair-label", { name: chair.name }) },
    h("b", {}, t("chairs-unpair-title", { name: chair.name })),
    h("p", {}, t("chairs-unpair-lead")),
    h(
      "div",
      { class: "spread" },
      h("button", { type: "button", class: "btn go", onclick: () => onUnpair(chair) }, t("chairs-unpair")),
      h("button", { type: "button", class: "btn", "data-first": true, onclick: onClose }, t("cancel")),
    ),
  );
}
