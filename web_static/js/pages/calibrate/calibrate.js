/**
 * The calibration wizard: its steps are kept by the server, so that a reload comes back to the same one.
 * @import { App } from "../../main.js"
 * @import { CalibrationView, Discovery, EquipmentView } from "types/api"
 * @import { Calibration, CalibrationResult } from "types/documents"
 * @import { Child } from "types/dom"
 * @import { Actions } from "./calibrate_step.js"
 */
import { beginNextTask } from "../drive/next_task.js";
import { calibrateStep } from "./calibrate_step.js";
import { failureWords } from "../../api.js";
import { discoveryCard } from "../../widgets/discovery_card.js";
import { h, put } from "../../widgets/dom.js";
import { labelsOf } from "../../widgets/joint_words.js";
import { drawnAgain } from "../../shell/focus_keeper.js";
import { emptyPage, patientHere } from "../../shell/nobody.js";
import { leftOutWords, resultView } from "./calibration_result.js";
import { showExpected } from "./map_origin.js";
import { stepBar } from "./step_bar.js";
import { t } from "../../texts.js";

const AUTO_PLACE = "bodydrive-calibrate-auto";
const PAUSE = 1500; // ms between two steps that follow by themselves: time to breathe out

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal }) {
  const here = patientHere(app, root);
  if (!here) return;
  const { api } = app; // the page's own instance: its changes name the session that this page was opened for
  const read = () => Promise.all([api.get("/calibration"), api.get("/equipment")]);
  let [view, equipment] = await read();
  let calibration = /** @type {Calibration} */ (view);
  if (!equipment.shirt && calibration.steps.length === 1) {
    emptyPage(root, t("calibrate-no-shirt"), t("calibrate-no-shirt-lead"), "#/shirt", t("calibrate-no-shirt-go"));
    return;
  }
  /** @type {string | null} */
  let runningStep = null; // the step whose run this page has seen: only after that one the next step starts by itself
  let timer = 0;
  let drawn = new AbortController();

  /** @param {CalibrationView} answer */
  const take = (answer) => {
    const before = calibration;
    calibration = /** @type {Calibration} */ (answer);
    if (answer.running) runningStep = answer.running.step;
    else if (before.running) afterStep(before.running.step);
    draw();
    if (before.running && !answer.running) sayOutcome(before.running.step);
  };
  /** Tell a screen reader how a step ended: the sentence is drawn with a new page, which nobody hears. @param {string} id */
  const sayOutcome = (id) => {
    const step = calibration.steps.find((one) => one.id === id);
    if (step?.message || step?.status === "done") app.toasts.announce(step.message || t("calibrate-done"));
  };
  /** @param {() => Promise<CalibrationView>} change */
  const call = async (change) => {
    clearTimeout(timer);
    timer = 0;
    try {
      const answer = await change();
      if (!signal.aborted) take(answer);
    } catch (error) {
      if (signal.aborted) return;
      app.toasts.show(failureWords(error));
      await readAgain();
    }
  };
  /** @param {boolean} [isNews] then the page is drawn only if something differs: what was opened on it stays open */
  const readAgain = async (isNews = false) => {
    const fresh = await read().catch(() => null);
    if (signal.aborted) return;
    if (isNews && fresh && shownOf(...fresh) === shownOf(calibration, equipment)) return;
    if (fresh) equipment = fresh[1];
    take(fresh ? fresh[0] : calibration);
  };
  /** @param {string} id */
  const start = (id) => call(() => api.post(`/calibration/steps/${id}/start`));
  /** @param {string} id */
  const afterStep = (id) => {
    const ended = calibration.steps.find((step) => step.id === id);
    const isGood = ended?.status === "done" && !ended.message && runningStep === id;
    runningStep = null;
    const next = calibration.steps.find((step) => step.id === calibration.current);
    if (
      !isGood ||
      !actions.isAuto ||
      !next ||
      next.kind === "result" ||
      next.status === "done" ||
      next.status === "skipped"
    )
      return;
    if (id === "free" && (calibration.may_drive_now || calibration.may_fit_earlier)) return; // a person chooses: drive now, or go on
    timer = setTimeout(() => start(next.id), PAUSE);
  };
  /** @type {Actions} */
  const actions = {
    go: (step) => call(() => api.post("/calibration/go", { step })),
    start,
    cancel: (step) => call(() => api.post(`/calibration/steps/${step}/cancel`)),
    skip: (step) => call(() => api.post(`/calibration/steps/${step}/skip`)),
    driveNow: () => driveNow(),
    fitEarlier: () => fitEarlier(),
    chooseMap: (joint, map) => call(() => api.post("/calibration/map", { joint, map })),
    saySitting: (joint, isRight) => call(() => api.post("/calibration/sitting", { joint, is_right: isRight })),
    setAuto: (on) => {
      localStorage.setItem(AUTO_PLACE, on ? "on" : "off");
      actions.isAuto = on;
      if (!on && timer) {
        clearTimeout(timer);
        timer = 0;
        draw();
      }
    },
    isAuto: localStorage.getItem(AUTO_PLACE) !== "off",
    get isGoingOn() {
      return timer !== 0;
    },
  };
  const driveNow = () =>
    app.toasts.attempt(async () => {
      const { result } = /** @type {Calibration} */ (await api.post("/calibration/drive-now"));
      await app.readSession();
      const sitsOtherwise = result?.joints.some(({ prior }) => prior && Object.keys(prior.arrangement).length > 0);
      if (sitsOtherwise)
        await readAgain(); // the result says so before anybody drives
      else await beginNextTask(app, here.patient.id);
    });
  const fitEarlier = () =>
    app.toasts.attempt(async () => {
      await api.post("/calibration/fit-earlier");
      await app.readSession();
      await beginNextTask(app, here.patient.id);
    });
  const accept = () =>
    app.toasts.attempt(async () => {
      await api.post("/calibration/accept");
      await app.readSession();
      app.go("#/controls");
    });
  const restart = () =>
    app.toasts.show(t("result-restart-ask"), {
      action: t("result-restart"),
      run: async () => {
        await call(() => api.post("/calibration/restart"));
        app.toasts.show(t("result-restarted"));
      },
    });
  const draw = () => {
    drawn.abort();
    drawn = new AbortController();
    signal.addEventListener("abort", () => drawn.abort(), { signal: drawn.signal });
    const { activeElement: before } = document;
    const hadFocus = before && root.contains(before) && before !== root.querySelector("h1");
    const choice = before?.closest(".segments")?.getAttribute("aria-label"); // the label of the choice of a map that has the focus
    const isResult = calibration.current === "result";
    const view = isResult
      ? resultPage(app, calibration, actions, { accept, drive: () => beginNextTask(app, here.patient.id) })
      : calibrateStep(app, calibration, equipment, actions, drawn.signal);
    put(
      root,
      h(
        "div",
        { class: `body${isResult ? "" : " one-screen"}` },
        stepBar(calibration.steps, calibration.current, actions.go, restart),
        h("h1", { tabindex: "-1" }, view.title),
        view.lead,
        view.body,
      ),
      h("div", { class: "foot" }, view.foot),
    );
    /** @param {string} selector @returns {HTMLElement | null} */
    const find = (selector) => root.querySelector(selector);
    if (!hadFocus) return;
    const same = choice ? find(`[aria-label="${CSS.escape(choice)}"] input:checked`) : drawnAgain(before);
    (same ?? find(".foot .btn.go") ?? find("h1"))?.focus({ preventScroll: true });
  };
  app.live.addEventListener(
    "changed",
    ({ detail }) => ["calibration", "equipment", "everything"].includes(detail.what) && readAgain(true),
    { signal },
  );
  signal.addEventListener("abort", () => clearTimeout(timer));
  if (calibration.running) runningStep = calibration.running.step;
  draw();
}

/** What the page shows of both, as one text: the free room on the disk always differs. @param {CalibrationView} calibration @param {EquipmentView} equipment */
const shownOf = (calibration, { shirt, body, layout }) => JSON.stringify([calibration, shirt, body, layout]);

/**
 * @param {App} app @param {Calibration} calibration @param {Actions} actions
 * @param {{accept: () => void, drive: () => Promise<unknown>}} next what can follow the result
 * @returns {{title: string, lead: Child, body: Child, foot: Child[]}}
 */
function resultPage(app, calibration, actions, { accept, drive }) {
  const { result, steps, running } = calibration;
  const missing = steps.filter(({ kind, status }) => kind !== "result" && status !== "done" && status !== "skipped");
  const [lastPrompt, last] = steps.slice(-2);
  const back = h("button", { type: "button", class: "btn", onclick: () => actions.go(lastPrompt.id) }, t("back"));
  if (running?.step === "result")
    return {
      title: t("calibrate-fitting"),
      lead: null,
      body: h("div", { class: "working", role: "status" }),
      foot: [back],
    };
  if (!result || (missing.length && !result.accepted)) {
    const words = missing.length ? t("result-missing-lead", { count: missing.length }) : last.message;
    const buttons = missing.map((step) =>
      h("button", { type: "button", class: "btn", onclick: () => actions.go(step.id) }, step.title),
    );
    return {
      title: t("result-missing"),
      lead: h("p", { class: "lead" }, words),
      body: h("div", { class: "spread" }, buttons),
      foot: [back],
    };
  }
  const onwards = onwardsOf(result, missing.length, accept, drive);
  return {
    title: t("result-title"),
    lead: h(
      "p",
      { class: "lead" },
      missing.length ? t("result-others-lead", { count: missing.length }) : t("result-lead"),
    ),
    body: resultBody(app, result, actions),
    foot: [
      back,
      h("span", { class: "grow" }, result.accepted ? t("result-accepted") : leftOutWords(result.left_out)),
      onwards,
    ],
  };
}

/**
 * The main button below a result: use it, drive with other people's part in it, or go on to the controls.
 * @param {CalibrationResult} result @param {number} missing how many movements other people stand in for
 * @param {() => void} accept @param {() => Promise<unknown>} drive
 */
function onwardsOf(result, missing, accept, drive) {
  if (!result.accepted) return h("button", { type: "button", class: "btn go", onclick: accept }, t("result-accept"));
  if (missing) return h("button", { type: "button", class: "btn go", onclick: drive }, t("calibrate-now-go"));
  return h("a", { class: "btn go", href: "#/controls" }, t("result-go-on"));
}

/** A card for each joint, and all movements that were found. @param {App} app @param {CalibrationResult} result @param {Actions} actions */
function resultBody(app, result, actions) {
  const joints = resultView(result, actions.start, actions.chooseMap, actions.saySitting);
  return [joints, foundGestures(app, result, ({ gestures }) => showExpected(joints, gestures))];
}

/**
 * All movements that were found; the suggestion can be taken once the calibration is in use.
 * @param {App} app @param {CalibrationResult} result @param {(found: Discovery) => void} onFound
 */
function foundGestures(app, result, onFound) {
  const labels = labelsOf(result.joints);
  const take = () =>
    app.toasts.attempt(async () => {
      await app.api.post("/controls/suggest");
      app.go("#/controls");
    });
  return discoveryCard(app.api, labels, result.accepted ? take : null, onFound);
}
