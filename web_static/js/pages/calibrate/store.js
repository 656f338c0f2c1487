/**
 * The calibration of the patient who is here, and what a person can do about it. The server keeps its steps, so that a
 * reload comes back to the same one.
 * @import { App } from "../../main.js"
 * @import { CalibrationView, Discovery, EquipmentView } from "types/api"
 * @import { Calibration, CalibrationStep } from "types/documents"
 * @import { RunMoment } from "../../widgets/cue_clock.js"
 * @typedef {ReturnType<typeof calibrationStore>} CalibrationStore
 * @typedef {"pca" | "guided" | "prior"} MapKind
 */
import { beginNextTask } from "../drive/next_task.js";
import { failureWords } from "../../api.js";
import { onNews } from "../../live/news.js";
import { computed, signal } from "../../preact.js";
import { t } from "../../texts.js";
import { runNow } from "../../widgets/cue_clock.js";

const AUTO_PLACE = "bodydrive-calibrate-auto";
const PAUSE = 1500; // ms between two steps that follow by themselves: time to breathe out

/** What the page shows, of the server. @param {import("../../api.js").Api} api */
export const readCalibration = (api) => Promise.all([api.get("/calibration"), api.get("/equipment")]);

/** Whether a step is neither recorded nor skipped. @param {CalibrationStep} step */
const isMissing = ({ kind, status }) => kind !== "result" && status !== "done" && status !== "skipped";

/**
 * @param {App} app @param {number} patient id @param {Awaited<ReturnType<typeof readCalibration>>} first
 * @param {AbortSignal} left of the page
 */
export function calibrationStore(app, patient, first, left) {
  const { api } = app; // the page's own instance: its changes name the session that this page was opened for
  const calibration = signal(/** @type {Calibration} */ (first[0]));
  const equipment = signal(first[1]);
  const found = signal(/** @type {Discovery | null} */ (null)); // the gestures of the result that is shown
  const moment = signal(/** @type {RunMoment | null} */ (null)); // of the step that is recorded
  const isAuto = signal(localStorage.getItem(AUTO_PLACE) !== "off");
  const isGoingOn = signal(false); // the next step begins by itself, after a pause
  /** The step that is shown. */
  const step = computed(() => {
    const { steps, current } = calibration.value;
    return steps.find(({ id }) => id === current) ?? steps[0];
  });
  const isRecording = computed(() => calibration.value.running?.step === step.value.id);
  const repetition = computed(() => (moment.value && step.value.cues[moment.value.index]?.repetition) ?? 0);
  const missing = computed(() => calibration.value.steps.filter(isMissing));
  /** The result while its figures are shown; null: a step is shown, the map is being fitted, or steps are missing. */
  const result = computed(() => {
    const fitted = step.value.kind === "result" && !isRecording.value ? calibration.value.result : null;
    return fitted?.accepted || !missing.value.length ? fitted : null;
  });
  let timer = 0; // until the next step begins; 0: it does not begin by itself
  let hasStarted = false; // whether this page began a step: only that page goes on by itself to driving
  let questions = 0;
  let newest = 0; // the question whose answer is shown

  /** @param {CalibrationView} view @param {EquipmentView} [equipmentNow] */
  const take = (view, equipmentNow = equipment.value) => {
    const { running: before } = calibration.value;
    calibration.value = /** @type {Calibration} */ (view);
    equipment.value = equipmentNow;
    if (before && !view.running) stepEnded(before.step);
    isGoingOn.value = timer !== 0;
    readFound();
  };
  /**
   * Show an answer of the server, unless that to a later question came first.
   * @param {() => Promise<Parameters<typeof take>>} question
   */
  const ask = async (question) => {
    const number = ++questions;
    const answer = await question();
    if (left.aborted || number < newest) return;
    newest = number;
    take(...answer);
  };
  const readAgain = () => ask(() => readCalibration(api)).catch(() => null);
  /** Make a change; whether it was accepted. @param {() => Promise<CalibrationView>} change */
  const call = async (change) => {
    stopTimer();
    try {
      await ask(async () => [await change()]);
      return true;
    } catch (error) {
      if (left.aborted) return false;
      app.toasts.show(failureWords(error));
      isGoingOn.value = false;
      calibration.value = { ...calibration.value }; // so that a choice stands as before
      await readAgain();
      return false;
    }
  };
  const readFound = async () => {
    const { value: asked } = calibration;
    if (!result.value) return void (found.value = null);
    const answer = await api.get("/calibration/gestures").catch(() => null); // the page says what is missing
    if (calibration.value === asked && !left.aborted) found.value = answer;
  };
  const stopTimer = () => {
    clearTimeout(timer);
    timer = 0;
  };
  /** Say how a step ended, and begin the next one where it may follow by itself. @param {string} id */
  const stepEnded = (id) => {
    const { steps, may_drive_now: mayDriveNow, may_fit_earlier: mayFitEarlier } = calibration.value;
    const ended = steps.find((one) => one.id === id);
    const isDone = ended?.status === "done";
    if (ended?.message || isDone) app.toasts.announce(ended.message || t("calibrate-done"));
    if (leadsOn()) return void driveByShort();
    if (!isDone || ended.message || !isAuto.value || !isMissing(step.value)) return;
    if (id === "free" && (mayDriveNow || mayFitEarlier)) return; // a person chooses: drive now, or go on
    const { id: next } = step.value;
    timer = setTimeout(() => start(next), PAUSE);
  };
  /**
   * Whether a short calibration of a demonstration, which has just ended on this page, is used without another tap:
   * every movement was recorded, and none has to be repeated.
   */
  const leadsOn = () => {
    const { short, steps } = calibration.value;
    const isFitted = result.value !== null && !result.value.accepted;
    const isGood = steps.every(({ status, message }) => status === "done" && message === "");
    return isFitted && isGood && short && app.me?.demo && isAuto.value && hasStarted;
  };
  /** @param {boolean} on */
  const setAuto = (on) => {
    localStorage.setItem(AUTO_PLACE, on ? "on" : "off");
    isAuto.value = on;
    if (on) return;
    stopTimer();
    isGoingOn.value = false;
  };
  /** @param {string} id of a step */
  const go = (id) => call(() => api.post("/calibration/go", { step: id }));
  /** @param {string} id of a step */
  const start = (id) => {
    hasStarted = true;
    return call(() => api.post(`/calibration/steps/${id}/start`));
  };
  /** @param {string} id of a step */
  const cancel = (id) => call(() => api.post(`/calibration/steps/${id}/cancel`));
  /** @param {string} id of a step */
  const skip = (id) => call(() => api.post(`/calibration/steps/${id}/skip`));
  /** @param {string} joint @param {MapKind} map */
  const chooseMap = (joint, map) => call(() => api.post("/calibration/map", { joint, map }));
  /** @param {string} joint @param {boolean} isRight */
  const saySitting = (joint, isRight) => call(() => api.post("/calibration/sitting", { joint, is_right: isRight }));
  const restart = () =>
    app.toasts.show(t("result-restart-ask"), {
      action: t("result-restart"),
      run: async () => {
        if (await call(() => api.post("/calibration/restart"))) app.toasts.show(t("result-restarted"));
      },
    });
  /**
   * Make a change that concerns the whole session, and go on.
   * @template Answer
   * @param {() => Promise<Answer>} change @param {(answer: Answer) => unknown} goOn
   */
  const finish = (change, goOn) =>
    app.toasts.attempt(async () => {
      const answer = await change();
      await app.readSession();
      await goOn(answer);
    });
  const drive = () => app.toasts.attempt(() => beginNextTask(app, patient));
  const showControls = () => app.go("#/controls");
  /** Begin with the short calibration, or with the whole one. @param {boolean} short */
  const chooseLength = (short) => call(() => api.post("/calibration/restart", { short }));
  /** @param {CalibrationView} view */
  const driveUnlessTurned = (view) => {
    const { joints = [] } = /** @type {Calibration} */ (view).result ?? {};
    const isTurned = joints.some(({ prior }) => prior && Object.keys(prior.arrangement).length > 0);
    return isTurned ? readAgain() : drive(); // the result says so before anybody drives
  };
  const driveNow = () => finish(() => api.post("/calibration/drive-now"), driveUnlessTurned);
  const fitEarlier = () => finish(() => api.post("/calibration/fit-earlier"), drive);
  const accept = () => finish(() => api.post("/calibration/accept"), showControls);
  const driveByShort = () => {
    hasStarted = false;
    return finish(
      () => api.post("/calibration/accept"),
      () => {
        app.toasts.show(t("calibrate-short-good"));
        app.go("#/drive");
      },
    );
  };
  const takeSuggestion = () => finish(() => api.post("/controls/suggest"), showControls);
  const followRun = () => {
    if (left.aborted) return;
    const now = isRecording.value ? runNow(app.live, step.value.cues) : null;
    if (now || !isRecording.value) moment.value = now; // where the run pauses between two messages, the cue stays
    requestAnimationFrame(followRun);
  };
  onNews(app, left, { what: ["calibration", "equipment"] }, readAgain);
  left.addEventListener("abort", stopTimer);
  followRun();
  readFound();
  const state = { calibration, equipment, found, moment, isAuto, isGoingOn };
  const derived = { step, isRecording, repetition, missing, result };
  const steps = { go, start, cancel, skip, setAuto, restart, chooseLength };
  const ofResult = { chooseMap, saySitting, accept, takeSuggestion };
  return { app, left, ...state, ...derived, ...steps, ...ofResult, drive, driveNow, fitEarlier };
}
