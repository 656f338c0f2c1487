/** The chairs that are paired: what they are called, where they are, what they may do; pair one, unpair one. */
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { day, number } from "../../widgets/format.js";
import { icon } from "../../widgets/icons.js";
import { pairForm } from "./pair_form.js";
import { pairedCard } from "../../widgets/one_time_key.js";

/** @param {import("../../main.js").App} app @param {any} chairs what GET /chairs answered @param {boolean} isOwner @param {AbortSignal} signal */
export function chairsCard(app, chairs, isOwner, signal) {
  const list = h("div", { class: "paired-chairs", role: "list" });
  const below = h("div", {});
  let asked = null; // the chair that somebody is about to unpair
  const draw = () =>
    put(
      list,
      chairs.chairs.map((chair) => row(chair)),
      !chairs.chairs.length && h("p", { class: "quiet" }, t("chairs.none")),
    );
  const readAgain = async ({ detail }) => {
    if (detail !== "equipment" && detail !== "everything") return;
    chairs = await app.api.get("/chairs").catch(() => chairs);
    draw();
  };
  const ask = (chair) => {
    asked = chair?.id ?? null;
    draw();
    list.querySelector("[data-first]")?.focus();
  };
  const unpair = async (chair) => {
    asked = null;
    try {
      chairs = await app.api.remove(`/chairs/${chair.id}`);
      app.toasts.show(t("chairs.unpaired", { name: chair.name }));
    } catch (error) {
      app.toasts.show(error.message);
    }
    draw();
  };
  const row = (chair) =>
    h(
      "div",
      { class: "paired-chair", role: "listitem" },
      h(
        "div",
        { class: "row" },
        h(
          "div",
          { class: "grow" },
          h("b", {}, chair.name),
          " ",
          h("span", { class: "quiet" }, t("chairs.address", { host: chair.host, port: chair.port })),
          h("div", { class: "quiet small" }, factsOf(chair)),
        ),
        isOwner &&
          h(
            "button",
            {
              type: "button",
              class: "icon-button",
              "aria-label": t("chairs.unpair.label", { name: chair.name }),
              title: t("chairs.unpair"),
              onclick: () => ask(chair),
            },
            icon("bin", 22),
          ),
      ),
      asked === chair.id && confirmation(chair, unpair, () => ask(null)),
    );
  const offer = () =>
    put(below, isOwner && h("button", { type: "button", class: "btn", onclick: openForm }, icon("plus", 20), t("chairs.pair")));
  const openForm = () => {
    put(below, pairForm(app, { onPaired: paired, onClose: offer }));
    below.querySelector("input").focus();
  };
  const paired = (answer, chair) => {
    chairs = answer;
    draw();
    const card = pairedCard(app, answer, chair, offer);
    put(below, card);
    card.querySelector("h2").focus();
    card.scrollIntoView({ block: "nearest" });
  };
  app.live.addEventListener("changed", readAgain, { signal });
  draw();
  offer();
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("chairs.title")),
    h("p", { class: "quiet small" }, t("chairs.lead")),
    list,
    below,
  );
}

function factsOf({ speeds, key_id: key, paired }) {
  const figures = { forward: number(speeds.forward, 2), reverse: number(speeds.reverse, 2), when: day(paired) };
  return `${t("chairs.facts", figures)} · ${t("chairs.key", { key })}`;
}

function confirmation(chair, onUnpair, onClose) {
  return h(
    "div",
    { class: "confirm", role: "group", "aria-label": t("chairs.unpair.label", { name: chair.name }) },
    h("b", {}, t("chairs.unpair.title", { name: chair.name })),
    h("p", {}, t("chairs.unpair.lead")),
    h(
      "div",
      { class: "spread" },
      h("button", { type: "button", class: "btn go", onclick: () => onUnpair(chair) }, t("chairs.unpair")),
      h("button", { type: "button", class: "btn", "data-first": true, onclick: onClose }, t("cancel")),
    ),
  );
}
