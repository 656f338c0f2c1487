/**
 * The foot of the calibration: back, and what can be done with a step or with the result.
 * @import { CalibrationStore } from "./store.js"
 */
import { startWords } from "./calibrate_step.js";
import { leftOutWords } from "./calibration_result.js";
import { Fragment, h, useFocusWithin } from "../../preact.js";
import { t } from "../../texts.js";
import { Toggle } from "../../widgets/fields.js";

/** @param {{store: CalibrationStore}} foot */
export function Foot({ store }) {
  useFocusWithin(".foot", ".foot .btn.go", ".foot .btn");
  return h(Fragment, {}, store.step.value.kind === "result" ? ofResult(store) : ofStep(store));
}

/**
 * A button of the foot.
 * @param {string} key from step to step, the button of a key is one element, which keeps the focus
 * @param {string} words @param {() => void} onClick
 */
function button(key, words, onClick, tone = "", disabled = false) {
  return h("button", { key, type: "button", class: `btn ${tone}`, disabled, onClick }, words);
}

/** @param {CalibrationStore} store */
function ofStep({ calibration, step, isRecording, isAuto, go, start, cancel, skip, setAuto }) {
  const { steps, running, may_drive_now: mayDriveNow, may_fit_earlier: mayFitEarlier } = calibration.value;
  const { id, kind, status, message } = step.value;
  const at = steps.indexOf(step.value);
  const isBusy = running !== null; // a step is recorded
  const isDone = status === "done";
  const isPoor = isDone && message !== ""; // then repeating is the main thing to do
  const tone = mayDriveNow || mayFitEarlier || isPoor ? "" : "go"; // otherwise another button is the main one
  const grow = h("span", { key: "grow", class: "grow" });
  const auto = h(Toggle, { key: "auto", label: t("calibrate-auto"), on: isAuto.value, onChange: setAuto });
  if (isRecording.value) return [button("cancel", t("calibrate-cancel"), () => cancel(id)), grow, auto];
  return [
    at > 0 && button("back", t("back"), () => go(steps[at - 1].id), "", isBusy),
    isDone && button("again", t("calibrate-again"), () => start(id), isPoor ? "go" : "", isBusy),
    grow,
    auto,
    !isDone && kind === "prompt" && button("skip", t("calibrate-skip"), () => skip(id), "", isBusy),
    isDone
      ? button("main", t("calibrate-next"), () => go(steps[at + 1].id), tone, isBusy)
      : button("main", t(startWords(step.value)), () => start(id), tone, isBusy),
  ];
}

/** @param {CalibrationStore} store */
function ofResult({ calibration, missing, result, go, accept, drive }) {
  const lastPrompt = calibration.value.steps.slice(-2)[0];
  const back = button("back", t("back"), () => go(lastPrompt.id));
  if (!result.value) return [back];
  const { accepted, left_out: leftOut } = result.value;
  const words = h("span", { key: "grow", class: "grow" }, accepted ? t("result-accepted") : leftOutWords(leftOut));
  if (!accepted) return [back, words, button("main", t("result-accept"), accept, "go")];
  if (missing.value.length) return [back, words, button("main", t("calibrate-now-go"), drive, "go")]; // others stand in
  return [back, words, h("a", { key: "main", class: "btn go", href: "#/controls" }, t("result-go-on"))];
}
