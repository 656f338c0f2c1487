/**
 * Controls: which movement does what, from where it counts, how fast the chair goes; tried without driving.
 * @import { App } from "../../main.js"
 * @import { LiveMessage } from "../../live/live.js"
 * @import { ControlsView } from "types/api"
 * @import { Control } from "./controls_draft.js"
 */
import { failureWords } from "../../api.js";
import { busyLine } from "../../shell/busy.js";
import { controlRow } from "./control_row.js";
import { ControlsDraft } from "./controls_draft.js";
import { cross } from "../../widgets/control_cross.js";
import { discoveryCard } from "../../widgets/discovery_card.js";
import { h, put, write } from "../../widgets/dom.js";
import { signedPercent } from "../../widgets/format.js";
import { jointLabels } from "../../widgets/gestures.js";
import { icon } from "../../widgets/icons.js";
import { emptyPage, patientHere } from "../../shell/nobody.js";
import { OTHER_SESSION } from "../../shell/other_session.js";
import { pads } from "../../widgets/pads.js";
import { ask as askPerson } from "../../widgets/question.js";
import { setsCard } from "./sets_card.js";
import { modesCard, speedsCard } from "./speeds_card.js";
import { t } from "../../texts.js";

/** @type {Control[]} */
const CONTROLS = ["u1+", "u1-", "u2+", "u2-", "stop"];

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal }) {
  const here = patientHere(app, root);
  if (!here) return;
  if (!here.hasProfile) {
    emptyPage(root, t("controls-none-title"), t("controls-none-lead"), "#/calibrate", t("controls-none-go"));
    return;
  }
  const [view, equipment] = await Promise.all([app.api.get("/controls"), app.api.get("/equipment")]);
  if (signal.aborted) return;
  const draft = new ControlsDraft(app.api, view);
  /** @type {Set<Control>} */
  const open = new Set(); // rows whose fine-tuning is open stay open when the page is drawn again
  // Both stand in the foot, which is in view wherever on the page a change was made.
  const state = h("span", { class: "grow", role: "status" });
  const problem = h("p", { class: "problem foot-line", role: "alert" });
  const suggestion = h("p", { class: "card suggestion", role: "status", hidden: true });
  const rowsPlace = h("section", { class: "card" });
  const sidePlace = h("div", { class: "stack" });
  const morePlace = h("div", { class: "controls-more" });
  const undo = iconButton("undo", () => ask(() => draft.api.post("/controls/undo")));
  const redo = iconButton("redo", () => ask(() => draft.api.post("/controls/redo")));
  const onward = h("a", { class: "btn go" }); // to driving, or to what is missing before
  const suggest = async () => {
    const answer = await askPerson(app.question, t("controls-suggest-ask"), [
      { value: "suggest", label: t("controls-suggest-go"), kind: "btn go" },
      { value: null, label: t("cancel") },
    ]);
    if (answer && !signal.aborted) await ask(() => draft.api.post("/controls/suggest"), true);
  };
  const suggestButton = h("button", { type: "button", class: "btn", onclick: suggest }, t("controls-suggest"));
  const title = h("span", {});
  /** @type {ReturnType<typeof controlRow>[]} */
  let rows = [];
  let speeds = speedsCard(draft);

  /** @param {() => Promise<ControlsView>} change @param {boolean} [saysWhy] whether the reason of the suggestion is shown */
  const ask = async (change, saysWhy = false) => {
    write(problem, "");
    try {
      await draft.ask(change);
      write(suggestion, saysWhy ? draft.view.suggested.reason : "");
      suggestion.hidden = !suggestion.textContent;
    } catch (error) {
      write(problem, failureWords(error));
    }
  };
  let isBusy = false;
  const showButtons = () => {
    undo.disabled = isBusy || !draft.view.can_undo;
    redo.disabled = isBusy || !draft.view.can_redo;
    suggestButton.disabled = isBusy;
    for (const place of [rowsPlace, morePlace, discovery]) place.inert = isBusy;
  };
  const showState = () => {
    const { message = "", page = "controls" } = draft.view.obstacle ?? {};
    write(problem, message);
    const isMendedHere = page === "controls";
    onward.href = isMendedHere ? "#/drive" : `#/${page}`;
    write(onward, t(isMendedHere ? "controls-drive" : `drive-obstacle-${page}`));
    showButtons();
    write(title, t("controls-lead", { title: draft.settings.title }));
  };
  const draw = () => {
    rows = CONTROLS.map((control) =>
      controlRow(control, draft, open.has(control), (name, isOpen) => (isOpen ? open.add(name) : open.delete(name))),
    );
    put(
      rowsPlace,
      rows.map(({ element }) => element),
    );
    speeds = speedsCard(draft);
    put(morePlace, modesCard(draft), speeds.element, setsCard(app, draft));
    showState();
  };
  draft.addEventListener("shape", draw);
  draft.addEventListener("handles", ({ detail }) => rows.forEach((row) => row.follow(detail)));
  draft.addEventListener("saving", () => {
    write(problem, "");
    write(state, t("controls-saving"));
  });
  draft.addEventListener("saved", () => {
    write(state, t("controls-saved"));
    speeds.showLowered();
    showState();
  });
  draft.addEventListener("obstacle", showState);
  draft.addEventListener("refused", ({ detail }) => {
    write(state, "");
    write(problem, detail);
  });
  put(sidePlace, tryCard(app, draft, signal));
  const discovery = discoveryCard(app.api, jointLabels(draft.profile), suggest);
  const busy = busyLine(app, signal, (is) => {
    isBusy = is;
    showButtons();
  });
  app.live.addEventListener("tick", ({ detail: now }) => rows.forEach((row) => row.showLive(now)), { signal });
  app.live.addEventListener(
    "changed",
    ({ detail }) => ["controls", "equipment", "everything"].includes(detail) && draft.readAgain().catch(() => null),
    { signal },
  );
  app.addEventListener("drafts", ({ detail }) => draft.isUnsent && detail.push(t("controls-draft")), { signal });
  signal.addEventListener("abort", () => (signal.reason === OTHER_SESSION ? draft.drop() : draft.flush()));

  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("controls-title")),
      h("div", { class: "lead controls-lead" }, title, undo, redo),
      suggestion,
      h("div", { class: "controls-columns" }, rowsPlace, sidePlace),
      morePlace,
      discovery,
      equipment.body?.kind === "visitor" && h("div", { class: "card pad-card docked" }, pads(app, signal).element),
    ),
    h(
      "div",
      { class: "foot" },
      busy,
      problem,
      suggestButton,
      h("a", { class: "btn bare", href: "#/adapt/look" }, t("adapt-link")),
      state,
      onward,
    ),
  );
  draw();
}

/** @param {"undo" | "redo"} name @param {() => void} run */
function iconButton(name, run) {
  return h(
    "button",
    { type: "button", class: "icon-button", "aria-label": t(name), title: t(name), onclick: run },
    icon(name, 22),
  );
}

/** u1 and u2 live, while the chair stands. @param {App} app @param {ControlsDraft} draft @param {AbortSignal} signal */
function tryCard(app, draft, signal) {
  const square = cross();
  const [u1, u2] = [h("b", { class: "number" }), h("b", { class: "number" })];
  const u1Words = h("span", {});
  /** @param {CustomEvent<LiveMessage>} event */
  const showLive = ({ detail: now }) => {
    square.show(now.u1 ?? 0, now.u2 ?? 0);
    write(u1, signedPercent(now.u1));
    write(u2, signedPercent(now.u2));
    write(u1Words, t(draft.settings.mode_u1 === "acceleration" ? "try-u1-acceleration" : "try-u1"));
  };
  app.live.addEventListener("tick", showLive, { signal });
  square.show(0, 0);
  return h(
    "section",
    { class: "card try" },
    h("h2", {}, t("try-title")),
    square.element,
    h("div", { class: "row" }, u1Words, u1),
    h("div", { class: "row" }, h("span", {}, t("try-u2")), u2),
    h("p", { class: "quiet small" }, t("try-note")),
  );
}
