/**
 * Before a real chair is armed: the chair as it is, what would apply, the body at rest; and what is still missing.
 * @import { App } from "../../main.js"
 * @import { ParametersSummary, Speeds } from "types/api"
 * @import { LiveMessage } from "../../live/live.js"
 */
import { t } from "../../texts.js";
import { armingSummary } from "./arming_summary.js";
import { chairCard } from "../../widgets/chair_card.js";
import { h, put, write } from "../../widgets/dom.js";
import { missingList, reasonsAgainst } from "./open_points.js";
import { neutralCard } from "./neutral_card.js";
import { pads } from "../../widgets/pads.js";

const NOT_A_BODY = new Set(["simulator", "replay"]); // kinds of shirts that nobody wears
const LOOK_EVERY = 3000; // ms between two looks at what is missing when nothing was heard to change

/**
 * @typedef {Awaited<ReturnType<typeof readArming>>} Reading what decides how a chair would drive
 * @typedef {NonNullable<Reading["summary"]>} Summary
 * @typedef {Summary & {parameters: ParametersSummary, speeds: Speeds}} FullSummary of a chair and a calibrated set
 * @typedef {Reading & {chair: NonNullable<Reading["chair"]>, summary: FullSummary}} FullReading
 */

/** Everything that decides how the chosen chair would drive. @param {import("../../api.js").Api} api */
export async function readArming(api) {
  const [chairs, controls, clinic, equipment] = await Promise.all([
    api.get("/chairs"),
    api.get("/controls"),
    api.get("/limits"),
    api.get("/equipment"),
  ]);
  const chair = chairs.chairs.find(({ id }) => id === chairs.chosen) ?? null;
  const summary = chair && (await api.get("/drives/summary"));
  return { chairs, chair, controls, clinic, equipment, summary };
}

/** Whether a demonstration lets a body that nobody has drive the chair. @param {App} app @param {Reading} read */
export function isSimulated(app, { equipment }) {
  return app.me?.demo && NOT_A_BODY.has(String(equipment.shirt?.kind));
}

/**
 * @param {App} app @param {HTMLElement} root @param {FullReading} read
 * @param {(id: number) => void} onDrive the chair is driven, from here or from elsewhere @param {AbortSignal} signal
 */
export function showArming(app, root, read, onDrive, signal) {
  const until = new AbortController(); // this part of the page ends when the chair is armed
  signal.addEventListener("abort", () => until.abort(), { signal: until.signal });
  /** @param {number} id */
  const drive = (id) => {
    until.abort();
    onDrive(id);
  };
  const useVirtual = async () => {
    const chosen = { id: null, dynamics: read.chairs.dynamics };
    if (await app.toasts.attempt(() => app.api.put("/chairs/chosen", chosen))) app.go("#/drive");
  };
  /** @param {string} title */
  const load = async (title) => {
    await app.toasts.attempt(() => app.api.post("/controls/load", { title }));
    await look();
  };
  const chair = chairCard(app.live, until.signal, { hasWhy: false }); // the list of what is missing does
  const settings = armingSummary({ onLoad: load, onPractise: useVirtual });
  const neutral = neutralCard(app.live, until.signal);
  const missing = missingList();
  const brief = h("span", { class: "grow" });
  const arm = h("button", { type: "button", class: "btn go large", "aria-describedby": "missing" });

  let isArming = false;
  const showMissing = () => {
    const reasons = reasonsAgainst(app.live, read.summary);
    missing.show(reasons);
    arm.disabled = isArming || reasons.length > 0;
    write(arm, t(isArming ? "arm-busy" : "arm-go"));
    write(brief, reasons.length ? t("arm-missing-short", { count: reasons.length }) : t("arm-front"));
  };
  const showAll = () => {
    settings.show({ ...read, dial: app.live.latest?.dial ?? 1 });
    neutral.use(read.controls);
    showMissing();
  };
  let isLooking = false;
  const look = async () => {
    if (isLooking) return;
    isLooking = true;
    const now = await readArming(app.api).catch(() => null);
    isLooking = false;
    if (until.signal.aborted || !now) return;
    if (!now.chair) return location.replace("#/drive");
    read = /** @type {FullReading} */ (now);
    showAll();
  };
  arm.addEventListener("click", async () => {
    isArming = true;
    showMissing();
    const { hash } = read.summary.parameters;
    const started = await app.toasts.attempt(() => app.api.post("/drives", { hash, screen: app.screen.word }));
    isArming = false;
    if (until.signal.aborted) return;
    if (started) drive(started.id);
    else await look();
  });

  let state = "";
  /** @param {CustomEvent<LiveMessage>} event */
  const follow = ({ detail: now }) => {
    if (now.drive && !isArming) return drive(now.drive.id);
    const before = state;
    state = [now.control, now.fault?.name, now.chair?.state, now.chair?.stop_input, now.dial].join();
    if (before && before !== state) look();
    showMissing();
  };
  app.live.addEventListener("tick", follow, { signal: until.signal });
  app.live.addEventListener("connection", showMissing, { signal: until.signal });
  app.live.addEventListener("changed", look, { signal: until.signal });
  const timer = setInterval(look, LOOK_EVERY);
  until.signal.addEventListener("abort", () => clearInterval(timer));

  const cards = [chair, settings, neutral];
  cards.forEach(({ title }, i) => title.prepend(h("span", { class: "step-number" }, String(i + 1))));
  const nobodySits = isSimulated(app, read);
  const isVisitor = read.equipment.body?.kind === "visitor";
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("chair-title", { name: read.chair.name })),
      h("p", { class: "lead" }, t(nobodySits ? "chair-lead-simulated" : "chair-lead")),
      nobodySits && h("p", { class: "card simulated" }, t("chair-simulated")),
      missing.element,
      h("div", { class: "arming" }, h("div", { class: "stack" }, chair.element, settings.element), neutral.element),
      isVisitor && h("div", { class: "card pad-card" }, pads(app, until.signal).element),
    ),
    h(
      "div",
      { class: "foot" },
      h("button", { type: "button", class: "btn", onclick: useVirtual }, t("chair-virtual")),
      brief,
      arm,
    ),
  );
  showAll();
}
