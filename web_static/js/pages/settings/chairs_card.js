/**
 * The chairs that are paired: what they are called, where they are, what they may do; pair one, unpair one.
 * @import { ChairsView, NewChair, PairedView } from "types/api"
 * @typedef {ChairsView["chairs"][number]} Chair
 */
import { passFocus } from "../../focus.js";
import { onNews } from "../../live/news.js";
import { focusFirst, h, useLayoutEffect, useRef, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { day, number } from "../../widgets/format.js";
import { Icon } from "../../widgets/icons.js";
import { useUntilGone } from "../../widgets/made.js";
import { PairForm } from "./pair_form.js";
import { PairedCard } from "../../widgets/one_time_key.js";

/**
 * @param {{app: import("../../main.js").App, first: ChairsView, isOwner: boolean, left: AbortSignal}} card
 *   first: what GET /chairs answered
 */
export function ChairsCard({ app, first, isOwner, left }) {
  const list = useSignal(first.chairs);
  const unpairing = useSignal(/** @type {number | null} */ (null)); // id of the chair that somebody is about to unpair
  // What is open below the list: the form, or the key of the chair that was just paired.
  const opened = useSignal(/** @type {"form" | {answer: PairedView, chair: Required<NewChair>} | null} */ (null));
  const wasOpened = useRef(false);
  const open = () => {
    opened.value = "form";
    wasOpened.current = true;
  };
  const close = () => void (opened.value = null);
  useUntilGone(left, (signal) =>
    onNews(app, signal, { what: ["equipment"] }, async () => {
      const answer = await app.api.get("/chairs").catch(() => null);
      if (answer) list.value = answer.chairs;
    }),
  );
  /** @param {Chair} chair */
  const unpair = (chair) => {
    unpairing.value = null;
    return app.toasts.attempt(async () => {
      list.value = (await app.api.remove(`/chairs/${chair.id}`)).chairs;
      app.toasts.show(t("chairs-unpaired", { name: chair.name }));
    });
  };
  /** @param {PairedView} answer @param {Required<NewChair>} chair */
  const showKey = (answer, chair) => {
    list.value = answer.chairs;
    opened.value = { answer, chair };
  };
  const below = () => {
    if (opened.value === "form") return h(PairForm, { app, onPaired: showKey, onClose: close });
    if (opened.value) return h(Key, { app, ...opened.value, onDone: close });
    return (
      isOwner &&
      h(
        "button",
        { type: "button", class: "btn", ref: wasOpened.current ? focusFirst : null, onClick: open },
        h(Icon, { name: "plus", size: 20 }),
        t("chairs-pair"),
      )
    );
  };
  /** @param {Chair} chair */
  const row = (chair) =>
    h(
      "div",
      { class: "paired-chair", role: "listitem", key: chair.id },
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
              ref: passFocus,
              onClick: () => (unpairing.value = chair.id),
            },
            h(Icon, { name: "bin", size: 22 }),
          ),
      ),
      unpairing.value === chair.id &&
        confirmation(
          chair.name,
          () => unpair(chair),
          () => (unpairing.value = null),
        ),
    );
  const chairs = list.value;
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("chairs-title")),
    h("p", { class: "quiet small" }, t("chairs-lead")),
    h(
      "div",
      { class: "paired-chairs", role: chairs.length ? "list" : undefined },
      chairs.length ? chairs.map(row) : h("p", { class: "quiet" }, t("chairs-none")),
    ),
    h("div", {}, below()),
  );
}

/** @param {Chair} chair */
function factsOf({ speeds, key_id: key, paired }) {
  const figures = { forward: number(speeds.forward, 2), reverse: number(speeds.reverse, 2), when: day(paired) };
  return `${t("chairs-facts", figures)} · ${t("chairs-key", { key })}`;
}

/**
 * The key of a chair, which is shown this once.
 * @param {{app: import("../../main.js").App, answer: PairedView, chair: Required<NewChair>, onDone: () => void}} key
 */
function Key(key) {
  const place = useRef(/** @type {HTMLDivElement | null} */ (null));
  useLayoutEffect(() => {
    place.current?.querySelector("h2")?.focus();
    place.current?.scrollIntoView({ block: "nearest" });
  }, []);
  return h("div", { ref: place }, h(PairedCard, key));
}

/** @param {string} name of a chair @param {() => unknown} onUnpair @param {() => unknown} onClose */
function confirmation(name, onUnpair, onClose) {
  return h(
    "div",
    { class: "confirm", role: "group", "aria-label": t("chairs-unpair-label", { name }) },
    h("b", {}, t("chairs-unpair-title", { name })),
    h("p", {}, t("chairs-unpair-lead")),
    h(
      "div",
      { class: "spread" },
      h("button", { type: "button", class: "btn go", onClick: onUnpair }, t("chairs-unpair")),
      h("button", { type: "button", class: "btn", ref: focusFirst, onClick: onClose }, t("cancel")),
    ),
  );
}
