/**
 * Controls: which movement does what, from where it counts, how fast the chair goes; tried without driving.
 * @import { Control, ControlsStore } from "./store.js"
 */
import { drawFoot, drawPage, Fragment, h } from "../../preact.js";
import { BusyLine } from "../../shell/busy.js";
import { emptyPage, patientHere } from "../../shell/nobody.js";
import { t } from "../../texts.js";
import { cross } from "../../widgets/control_cross.js";
import { FoundNow } from "../../widgets/discovery_card.js";
import { signedPercent } from "../../widgets/format.js";
import { Icon } from "../../widgets/icons.js";
import { Made } from "../../widgets/made.js";
import { pads } from "../../widgets/pads.js";
import { ControlRow } from "./control_row.js";
import { SetsCard } from "./sets_card.js";
import { ModesCard, SpeedsCard } from "./speeds_card.js";
import { controlsStore } from "./store.js";

/** @type {Control[]} */
const CONTROLS = ["u1+", "u1-", "u2+", "u2-", "stop"];

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal: left }) {
  const here = patientHere(app, root);
  if (!here) return;
  if (!here.hasProfile) {
    emptyPage(root, t("controls-none-title"), t("controls-none-lead"), "#/calibrate", t("controls-none-go"));
    return;
  }
  const [view, equipment] = await Promise.all([app.api.get("/controls"), app.api.get("/equipment")]);
  if (left.aborted) return;
  const store = controlsStore(app, view, left);
  drawPage(root, h(Page, { store, isVisitor: equipment.body?.kind === "visitor" }));
  drawFoot(root, h(Foot, { store }));
}

/** @param {{store: ControlsStore, isVisitor: boolean}} page isVisitor: a visitor moves the simulated body */
function Page({ store, isVisitor }) {
  const { app, left, busy, labels, suggestion, suggest } = store;
  const inert = busy.value !== undefined;
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, t("controls-title")),
    h(Lead, { store }),
    h("p", { class: "card suggestion", role: "status", hidden: !suggestion.value }, suggestion.value),
    h(
      "div",
      { class: "controls-columns" },
      h(
        "section",
        { class: "card", inert },
        CONTROLS.map((control) => h(ControlRow, { key: control, store, control })),
      ),
      h("div", { class: "stack" }, h(TryCard, { store })),
    ),
    h(
      "div",
      { class: "controls-more", inert },
      h(ModesCard, { store }),
      h(SpeedsCard, { store }),
      h(SetsCard, { store }),
    ),
    h("div", { inert }, h(FoundNow, { api: app.api, labels: labels.value, onTake: suggest })),
    isVisitor && h(Made, { class: "card pad-card docked", left, make: (gone) => pads(app, gone).element }),
  );
}

/** @param {{store: ControlsStore}} lead */
function Lead({ store: { busy, settings, view, undo, redo } }) {
  /** @param {"undo" | "redo"} name @param {() => void} onClick */
  const button = (name, onClick) => {
    const isOff = busy.value !== undefined || !view.value[`can_${name}`];
    return h(
      "button",
      {
        type: "button",
        class: "icon-button",
        "aria-label": t(name),
        title: t(name),
        "aria-disabled": isOff || undefined,
        onClick: () => void (isOff || onClick()),
      },
      h(Icon, { name, size: 22 }),
    );
  };
  return h(
    "div",
    { class: "lead controls-lead" },
    h("span", {}, t("controls-lead", { title: settings.value.title })),
    button("undo", undo),
    button("redo", redo),
  );
}

/** u1 and u2 live, while the chair stands. @param {{store: ControlsStore}} card */
function TryCard({ store: { app, left, live, settings } }) {
  const now = live.value;
  const keepsSpeed = settings.value.mode_u1 === "acceleration";
  /** @param {AbortSignal} gone */
  const liveCross = (gone) => {
    const square = cross();
    square.show(0, 0);
    app.live.addEventListener("tick", ({ detail: { u1, u2 } }) => square.show(u1 ?? 0, u2 ?? 0), { signal: gone });
    return square.element;
  };
  return h(
    "section",
    { class: "card try" },
    h("h2", {}, t("try-title")),
    h(Made, { left, make: liveCross }),
    h(
      "div",
      { class: "row" },
      h("span", {}, t(keepsSpeed ? "try-u1-acceleration" : "try-u1")),
      h("b", { class: "number" }, now && signedPercent(now.u1)),
    ),
    h("div", { class: "row" }, h("span", {}, t("try-u2")), h("b", { class: "number" }, now && signedPercent(now.u2))),
    h("p", { class: "quiet small" }, t("try-note")),
  );
}

/** It is in view wherever on the page a change was made. @param {{store: ControlsStore}} foot */
function Foot({ store: { busy, view, problem, state, suggest } }) {
  const { message = "", page = "controls" } = view.value.obstacle ?? {};
  const isMendedHere = page === "controls";
  return h(
    Fragment,
    {},
    h(BusyLine, { kind: busy.value }),
    h("p", { class: "problem foot-line", role: "alert" }, problem.value || message),
    h(
      "button",
      { type: "button", class: "btn", disabled: busy.value !== undefined, onClick: suggest },
      t("controls-suggest"),
    ),
    h("a", { class: "btn bare", href: "#/adapt/look" }, t("adapt-link")),
    h("span", { class: "grow", role: "status" }, state),
    h(
      "a",
      { class: "btn go", href: isMendedHere ? "#/drive" : `#/${page}` },
      t(isMendedHere ? "controls-drive" : `drive-obstacle-${page}`),
    ),
  );
}
