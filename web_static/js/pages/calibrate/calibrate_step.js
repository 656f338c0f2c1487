/**
 * One step of the calibration: what to do, the cue, and the signals as they come.
 * @import { ShirtLayout } from "types/api"
 * @import { CalibrationStep } from "types/documents"
 * @import { CalibrationStore } from "./store.js"
 */
import { drawTraces, middle, QUIET_SPAN } from "../../charts/joint_strips.js";
import { TraceCanvas } from "../../charts/traces.js";
import { Fragment, h } from "../../preact.js";
import { t } from "../../texts.js";
import { CueCircle } from "../../widgets/cue_circle.js";
import { day } from "../../widgets/format.js";
import { Made } from "../../widgets/made.js";
import { pads } from "../../widgets/pads.js";

/** Who moves, by the kind of the body in the simulated shirt. @type {Record<string, string>} */
const READY = { person: "self", recorded: "self", visitor: "visitor" };

/** @param {{store: CalibrationStore}} step */
export function Step({ store }) {
  const { app, left, calibration, equipment, step, moment, isRecording } = store;
  const { title, cues, joint, message } = step.value;
  const { shirt, body, layout } = equipment.value;
  const isVisitor = body?.kind === "visitor" && shirt?.kind === "simulator";
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, title),
    h(Lead, { store }),
    h(
      "div",
      { class: "step-body" },
      !calibration.value.running && h(Ready, { store }),
      h(CueCircle, {
        cues,
        moment,
        isRunning: isRecording.value,
        idleWords: idleWords(store),
        announce: (words) => app.toasts.announce(words),
      }),
      message && !isRecording.value && h("p", { class: "problem" }, message),
      layout &&
        h(Made, { key: traceKey(layout, joint), left, make: (gone) => trace(app.live, layout, joint, gone).element }),
      isVisitor && h(Made, { key: "pads", left, make: (gone) => pads(app, gone).element }),
    ),
  );
}

/** @param {{store: CalibrationStore}} lead */
function Lead({ store: { calibration, step, repetition } }) {
  const { steps } = calibration.value;
  const { cues, instruction } = step.value;
  const all = Math.max(0, ...cues.map((cue) => cue.repetition));
  const parts = [
    t("calibrate-step", { step: steps.indexOf(step.value) + 1, steps: steps.length }),
    repetition.value ? t("calibrate-repetition", { repetition: repetition.value, all }) : "",
    instruction,
  ];
  return h("p", { class: "lead" }, parts.filter(Boolean).join(" · "));
}

/**
 * What makes driving possible before the prompted movements: this person's earlier calibration, or else other people.
 * @param {{store: CalibrationStore}} card
 */
function Ready({ store: { calibration, fitEarlier, driveNow } }) {
  const { earlier, may_fit_earlier: mayFitEarlier, others, may_drive_now: mayDriveNow } = calibration.value;
  const of = earlier && { version: earlier.version, day: day(earlier.created) };
  if (mayFitEarlier) return readyCard(t("calibrate-earlier-lead", of ?? {}), t("calibrate-earlier-go"), fitEarlier);
  if (mayDriveNow) return readyCard(t("calibrate-now-lead", { count: others }), t("calibrate-now-go"), driveNow);
  return of && h("p", { class: "card small" }, t("calibrate-earlier", of));
}

/** @param {string} lead @param {string} go @param {() => void} onClick */
function readyCard(lead, go, onClick) {
  return h(
    "section",
    { class: "card drive-now" },
    h("div", {}, h("h2", {}, t("calibrate-now")), h("p", { class: "small" }, lead)),
    h("button", { type: "button", class: "btn go", onClick }, go),
  );
}

/** @param {CalibrationStore} store */
function idleWords({ step, equipment, isGoingOn }) {
  const { status, message } = step.value;
  if (isGoingOn.value) return t("calibrate-going-on");
  if (status === "done") return t(message ? "calibrate-poor" : "calibrate-done");
  const who = READY[String(equipment.value.body?.kind)] ?? "patient";
  return t(`calibrate-ready-${who}`, { button: t(startWords(step.value)) });
}

/** The key of the words on the button that records a step. @param {CalibrationStep} step */
export function startWords({ status }) {
  return status === "failed" ? "calibrate-again" : "calibrate-start";
}

/** What a trace is drawn by: with others, it begins anew. @param {ShirtLayout} layout @param {string | null} joint */
function traceKey({ channels }, joint) {
  return ["trace", joint, ...channels.map((channel) => channel.joint)].join();
}

/**
 * The joint's own channels while it is prompted; otherwise one line per joint.
 * @param {import("../../live/live.js").Live} live @param {ShirtLayout} layout @param {string | null} joint
 * @param {AbortSignal} gone
 */
function trace(live, { channels, joints }, joint, gone) {
  const canvas = new TraceCanvas({ label: t("cue-trace"), height: 84 });
  /** @param {string} name of a joint */
  const indices = (name) => channels.flatMap((channel, index) => (channel.joint === name ? [index] : []));
  const own = joint ? indices(joint) : null;
  const groups = joints.map(({ name }) => indices(name));
  /** @param {(number | null)[]} frame @param {number[]} group indices */
  const mean = (frame, group) => group.reduce((sum, index) => sum + (frame[index] ?? 0), 0) / group.length;
  live.addEventListener("quality", () => (canvas.floor = QUIET_SPAN * middle(live.noise)), { signal: gone });
  /** @param {{values?: (number | null)[] | null}} now */
  const values = ({ values: frame }) =>
    own ? own.map((index) => frame?.[index] ?? null) : groups.map((group) => mean(frame ?? [], group));
  drawTraces(live, [{ canvas, values }], gone);
  return canvas;
}
