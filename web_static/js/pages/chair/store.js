/**
 * What the page before arming shows: everything that decides how the chair would drive, and what is still missing.
 * @import { App } from "../../main.js"
 * @import { ParametersSummary, Speeds } from "types/api"
 * @import { LiveMessage } from "../../live/live.js"
 */
import { onNews } from "../../live/news.js";
import { computed, signal } from "../../preact.js";
import { t } from "../../texts.js";
import { boundGestures } from "./gesture_levels.js";

const NOT_A_BODY = new Set(["simulator", "replay"]); // kinds of shirts that nobody wears
const LOOK_EVERY = 3000; // ms between two looks at what is missing when nothing was heard to change
/** @type {import("../../live/news.js").Interest} what decides how a chair would drive */
const DECIDING = { what: ["session", "calibration", "controls", "equipment", "trial", "drive"] };

/**
 * @typedef {Awaited<ReturnType<typeof readArming>>} Reading what decides how a chair would drive
 * @typedef {NonNullable<Reading["summary"]>} Summary
 * @typedef {Summary & {parameters: ParametersSummary, speeds: Speeds, hash: string}} FullSummary of a chair and a calibrated set
 * @typedef {Reading & {chair: NonNullable<Reading["chair"]>, summary: FullSummary}} FullReading
 * @typedef {FullReading & {dial: number}} Application what arming would apply, and the dial's share
 * @typedef {ReturnType<typeof armingStore>} ArmingStore
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

/**
 * Who moves: `isSimulated`: a demonstration lets a body that nobody has drive the chair; `isVisitor`: by the pads.
 * @param {App} app @param {Reading} read
 */
export function bodyOf(app, { equipment }) {
  return {
    isSimulated: Boolean(app.me?.demo && NOT_A_BODY.has(String(equipment.shirt?.kind))),
    isVisitor: equipment.body?.kind === "visitor",
  };
}

/**
 * @param {App} app @param {FullReading} first
 * @param {(id: number) => void} onDrive the chair is driven, from here or from elsewhere @param {AbortSignal} pageLeft
 */
export function armingStore(app, first, onDrive, pageLeft) {
  const armed = new AbortController();
  const left = AbortSignal.any([pageLeft, armed.signal]); // this part of the page ends when the chair is armed
  /** @param {FullReading} read @returns {Application} */
  const withDial = (read) => ({ ...read, dial: app.live.latest?.dial ?? 1 });
  const reading = signal(withDial(first));
  const latest = signal(app.live.latest);
  const chair = signal(app.live.latest?.chair ?? null); // as it told of itself last
  const isConnected = signal(app.live.connected);
  const isArming = signal(false);
  const gestures = computed(() => boundGestures(reading.value.controls.parameters));
  const isLost = computed(() => !isConnected.value || latest.value?.control !== "alive");
  const hasFault = computed(() => Boolean(latest.value?.fault));
  /** What is missing. The page's own reasons come first: without a live link the server's may be out of date. */
  const reasons = computed(() => {
    if (isLost.value) return [t("arm-lost")];
    return [...new Set([...(hasFault.value ? [t("arm-fault")] : []), ...reading.value.summary.refusals])];
  });
  /** @param {number} id */
  const drive = (id) => {
    armed.abort();
    onDrive(id);
  };
  const chooseVirtual = async () => {
    const chosen = { id: null, dynamics: reading.value.chairs.dynamics };
    if (await app.toasts.attempt(() => app.api.put("/chairs/chosen", chosen))) app.go("#/drive");
  };
  /** @param {string} title of a set */
  const load = async (title) => {
    await app.toasts.attempt(() => app.api.post("/controls/load", { title }));
    await look();
  };
  const arm = async () => {
    isArming.value = true;
    const { hash } = reading.value.summary;
    const started = await app.toasts.attempt(() => app.api.post("/drives", { hash, screen: app.screen.word }));
    isArming.value = false;
    if (left.aborted) return;
    if (started) drive(started.id);
    else await look();
  };
  let isLooking = false;
  const look = async () => {
    if (isLooking) return;
    isLooking = true;
    const now = await readArming(app.api).catch(() => null);
    isLooking = false;
    if (left.aborted || !now) return;
    if (!now.chair) return location.replace("#/drive");
    reading.value = withDial(/** @type {FullReading} */ (now));
  };
  let state = "";
  /** @param {CustomEvent<LiveMessage>} event */
  const follow = ({ detail: now }) => {
    if (now.drive && !isArming.value) return drive(now.drive.id);
    const before = state;
    state = [now.control, now.fault?.name, now.chair?.state, now.chair?.stop_input, now.dial].join();
    if (before && before !== state) look();
    latest.value = now;
    chair.value = now.chair ?? chair.value;
  };
  app.live.addEventListener("tick", follow, { signal: left });
  app.live.addEventListener("connection", ({ detail }) => void (isConnected.value = detail), { signal: left });
  onNews(app, left, DECIDING, look);
  const timer = setInterval(look, LOOK_EVERY);
  left.addEventListener("abort", () => clearInterval(timer));
  const signals = { reading, chair, isArming, gestures, reasons };
  return { app, left, name: first.chair.name, ...bodyOf(app, first), ...signals, arm, chooseVirtual, load };
}
