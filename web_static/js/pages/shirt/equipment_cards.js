/**
 * The cards that say what is in use: the source of movements, who is inside a simulated shirt, the head tracker; each
 * has a form to change that.
 * @import { ShirtStore } from "./store.js"
 * @import { EquipmentView } from "types/api"
 * @import { ComponentChildren } from "../../preact.js"
 * @typedef {(call: Promise<EquipmentView>) => Promise<void>} Use waits for a change, then closes the form
 */
import { giveFocus } from "../../focus.js";
import { h, useLayoutEffect, useRef, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { BodyForm, bodyWords } from "./body_form.js";
import { HeadActions, HeadForm, headWords } from "./head_card.js";
import { PairedPhones } from "./paired_phones.js";
import { ShirtSender } from "./shirt_sender.js";
import { SourceForm, sourceWords } from "./source_form.js";
import { SourcePicture } from "./source_pictures.js";
import { WhatArrives } from "./what_arrives.js";

/** @param {{store: ShirtStore}} card */
export function SourceCard({ store }) {
  const { app, kinds, equipment } = store;
  const { shirt } = equipment.value;
  const source = kinds.find(({ kind }) => kind === shirt?.kind);
  const now = h(
    "div",
    { class: "source-now" },
    shirt && h(SourcePicture, { kind: shirt.kind }),
    h(
      "div",
      { class: "grow" },
      h("p", {}, sourceWords(shirt, kinds)),
      source && h("p", { class: "quiet small" }, source.may_arm),
      shirt && h(WhatArrives, { store }),
    ),
  );
  return h(
    Card,
    {
      store,
      name: "source",
      now,
      startsOpen: !shirt, // choosing one is the next step
      form: (use) => h(SourceForm, { store, onUse: (config) => use(app.api.put("/equipment/shirt", config)) }),
    },
    source?.network && h(ShirtSender, { store }),
    shirt?.kind === "phones" && h(PairedPhones, { store }),
  );
}

/** Which channels the shirt has, and the way to the page that says where they are; a reviewer may not see that page. @param {{store: ShirtStore}} card */
export function LayoutCard({ store: { app, equipment } }) {
  const { layout } = equipment.value;
  if (!layout || app.me?.role === "reviewer") return null;
  return h(
    "section",
    { class: "card", "data-card": "layout" },
    h("h2", {}, t("layouts-card")),
    h("p", {}, t("layouts-card-now", { name: layout.name, count: layout.channels.length })),
    h("a", { class: "btn small", href: "#/layouts" }, t("layouts-back")),
  );
}

/** @param {{store: ShirtStore}} card */
export function BodyCard({ store }) {
  const { app, equipment } = store;
  const { body } = equipment.value;
  return h(Card, {
    store,
    name: "body",
    now: h("p", {}, body ? bodyWords(body) : ""),
    form: (use) => h(BodyForm, { store, onUse: (config) => use(app.api.put("/equipment/body", config)) }),
  });
}

/** @param {{store: ShirtStore}} card */
export function HeadCard({ store }) {
  const { app, equipment } = store;
  const { config, message } = equipment.value.head;
  return h(
    Card,
    {
      store,
      name: "head",
      now: h("p", {}, [headWords(config), config && message].filter(Boolean).join(" ")),
      form: (use) => h(HeadForm, { store, onUse: (chosen) => use(app.api.put("/equipment/head", { config: chosen })) }),
    },
    h(HeadActions, { store }),
  );
}

/**
 * @param {object} card
 * @param {ShirtStore} card.store @param {"source" | "body" | "head"} card.name
 * @param {ComponentChildren} card.now what is in use @param {boolean} [card.startsOpen]
 * @param {(use: Use) => ComponentChildren} card.form
 * @param {ComponentChildren} [card.children] below the form
 */
function Card({ store, name, now, startsOpen = false, form, children }) {
  const isOpen = useSignal(startsOpen);
  const changes = useSignal(0);
  const card = useRef(/** @type {HTMLElement | null} */ (null));
  /** @type {Use} */
  const use = async (call) => {
    store.take(await call);
    isOpen.value = false;
    changes.value++;
  };
  useLayoutEffect(() => {
    if (!changes.value) return;
    giveFocus(card.current?.querySelector("summary"));
    card.current?.scrollIntoView({ block: "nearest" }); // the page has become shorter
  }, [changes.value]);
  return h(
    "section",
    { class: "card", "data-card": name, ref: card },
    h("h2", {}, t(`${name}-title`)),
    now,
    h(
      "details",
      {
        open: isOpen.value,
        onToggle: (/** @type {Event} */ { currentTarget }) =>
          void (isOpen.value = /** @type {HTMLDetailsElement} */ (currentTarget).open),
      },
      h("summary", {}, t("source-change")),
      h("div", {}, isOpen.value && form(use)),
    ),
    children,
  );
}
