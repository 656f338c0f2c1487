/**
 * One step of the calibration: what to do, the cue, the signals as they come, and what can be done next.
 * @import { App } from "../../main.js"
 * @import { EquipmentView, ShirtLayout } from "types/api"
 * @import { Calibration, CalibrationStep } from "types/documents"
 * @import { Child } from "types/dom"
 */
import { t } from "../../texts.js";
import { cueCircle } from "../../widgets/cue_circle.js";
import { h, write } from "../../widgets/dom.js";
import { day } from "../../widgets/format.js";
import { toggle } from "../../widgets/fields.js";
import { drawTraces, middle, QUIET_SPAN } from "../../charts/joint_strips.js";
import { pads } from "../../widgets/pads.js";
import { TraceCanvas } from "../../charts/traces.js";

/** Who moves, by the kind of the body in the simulated shirt. @type {Record<string, string>} */
const READY = { person: "self", recorded: "self", visitor: "visitor" };

/**
 * @typedef {{go: (id: string) => void, start: (id: string) => void, cancel: (id: string) => void, skip: (id: string) => void,
 *   chooseMap: (joint: string, map: "pca" | "guided" | "prior") => void, saySitting: (joint: string, isRight: boolean) => void, driveNow: () => void, fitEarlier: () => void,
 *   setAuto: (on: boolean) => void, isAuto: boolean, readonly isGoingOn: boolean}} Actions
 */

/**
 * @param {App} app @param {Calibration} calibration @param {EquipmentView} equipment
 * @param {Actions} actions @param {AbortSignal} signal
 * @returns {{title: string, lead: Child, body: Child, foot: Child[]}}
 */
export function calibrateStep(app, calibration, equipment, actions, signal) {
  const { steps, current, running } = calibration;
  const at = steps.findIndex(({ id }) => id === current);
  const step = steps[at];
  const isRunning = running?.step === current;
  const repetitions = Math.max(0, ...step.cues.map(({ repetition }) => repetition));
  const lead = h("p", { class: "lead" });
  /** @param {number} repetition 0 while nothing is repeated */
  const showLead = (repetition) =>
    write(
      lead,
      [
        t("calibrate-step", { step: at + 1, steps: steps.length }),
        repetition ? t("calibrate-repetition", { repetition, all: repetitions }) : "",
        step.instruction,
      ]
        .filter(Boolean)
        .join(" · "),
    );
  showLead(0);
  const circle = cueCircle(app, step, {
    isRunning,
    idleWords: idleWords(step, equipment, actions),
    signal,
    onCue: (cue) => showLead(cue.repetition),
  });
  const isVisitor = equipment.body?.kind === "visitor" && equipment.shirt?.kind === "simulator";
  const body = h(
    "div",
    { class: "step-body" },
    !running && readyCard(calibration, actions),
    circle,
    step.message && !isRunning && h("p", { class: "problem" }, step.message),
    stepTrace(app, equipment.layout, step, signal),
    isVisitor && pads(app, signal).element,
  );
  const isReady = calibration.may_drive_now || calibration.may_fit_earlier;
  return { title: step.title, lead, body, foot: foot(steps, at, isRunning, Boolean(running), isReady, actions) };
}

/**
 * What makes driving possible before the prompted movements: this person's earlier calibration, or else other people.
 * @param {Calibration} calibration @param {Actions} actions
 */
function readyCard({ earlier, may_fit_earlier: mayFitEarlier, others, may_drive_now: mayDriveNow }, actions) {
  const of = earlier && { version: earlier.version, day: day(earlier.created) };
  if (mayFitEarlier) return card(t("calibrate-earlier-lead", of ?? {}), t("calibrate-earlier-go"), actions.fitEarlier);
  if (mayDriveNow) return card(t("calibrate-now-lead", { count: others }), t("calibrate-now-go"), actions.driveNow);
  return of && h("p", { class: "card small" }, t("calibrate-earlier", of));
}

/** @param {string} lead @param {string} go @param {() => void} run */
function card(lead, go, run) {
  return h(
    "section",
    { class: "card drive-now" },
    h("div", {}, h("h2", {}, t("calibrate-now")), h("p", { class: "small" }, lead)),
    h("button", { type: "button", class: "btn go", onclick: run }, go),
  );
}

/** @param {CalibrationStep} step @param {EquipmentView} equipment @param {Actions} actions */
function idleWords(step, equipment, { isGoingOn }) {
  if (isGoingOn) return t("calibrate-going-on");
  if (step.status === "done") return t(step.message ? "calibrate-poor" : "calibrate-done");
  const who = READY[String(equipment.body?.kind)] ?? "patient";
  return t(`calibrate-ready-${who}`, { button: t(startWords(step)) });
}

/** The key of the words on the button that records it. @param {CalibrationStep} step */
function startWords({ status }) {
  return status === "failed" ? "calibrate-again" : "calibrate-start";
}

/**
 * @param {CalibrationStep[]} steps @param {number} at @param {boolean} isRunning this step is being recorded
 * @param {boolean} isBusy any step is @param {boolean} isReady then the button that drives is the main one
 * @param {Actions} actions @returns {Child[]}
 */
function foot(steps, at, isRunning, isBusy, isReady, actions) {
  const step = steps[at];
  /** @param {string} words @param {() => void} run */
  const button = (words, run, tone = "", isOff = false) =>
    h("button", { type: "button", class: `btn ${tone}`, disabled: isOff, onclick: run }, words);
  if (isRunning)
    return [button(t("calibrate-cancel"), () => actions.cancel(step.id)), h("span", { class: "grow" }), auto(actions)];
  const isDone = step.status === "done";
  const isPoor = isDone && step.message !== ""; // then repeating is the main thing to do
  const tone = isReady || isPoor ? "" : "go";
  return [
    at > 0 && button(t("back"), () => actions.go(steps[at - 1].id), "", isBusy),
    isDone && button(t("calibrate-again"), () => actions.start(step.id), isPoor ? "go" : "", isBusy),
    h("span", { class: "grow" }),
    auto(actions),
    !isDone && step.kind === "prompt" && button(t("calibrate-skip"), () => actions.skip(step.id), "", isBusy),
    isDone
      ? button(t("calibrate-next"), () => actions.go(steps[at + 1].id), tone, isBusy)
      : button(t(startWords(step)), () => actions.start(step.id), tone, isBusy),
  ];
}

/** @param {Actions} actions */
function auto(actions) {
  return toggle(t("calibrate-auto"), actions.isAuto, actions.setAuto);
}

/**
 * The joint's own channels while it is prompted; otherwise one line per joint.
 * @param {App} app @param {ShirtLayout | null} layout @param {CalibrationStep} step @param {AbortSignal} signal
 */
function stepTrace(app, layout, step, signal) {
  if (!layout) return null;
  const canvas = new TraceCanvas({ label: t("cue-trace"), height: 84 });
  /** @param {string} joint */
  const indices = (joint) => layout.channels.flatMap((channel, index) => (channel.joint === joint ? [index] : []));
  const groups = layout.joints.map(({ name }) => indices(name));
  app.live.addEventListener("quality", () => (canvas.floor = QUIET_SPAN * middle(app.live.noise)), { signal });
  /** @param {(number | null)[]} values @param {number[]} group indices */
  const mean = (values, group) => group.reduce((sum, index) => sum + (values[index] ?? 0), 0) / group.length;
  const own = step.joint ? indices(step.joint) : null;
  drawTraces(
    app.live,
    [
      {
        canvas,
        values: ({ values }) => {
          const frame = values ?? [];
          return own ? own.map((index) => frame[index]) : groups.map((group) => mean(frame, group));
        },
      },
    ],
    signal,
  );
  return canvas.element;
}
