/**
 * The wizard of the calibration: one step after the other, and what they came to.
 * @import { CalibrationStore } from "./store.js"
 */
import { CalibrationResult } from "./calibration_result.js";
import { Step } from "./calibrate_step.js";
import { Foot } from "./foot.js";
import { drawFoot, drawPage, Fragment, h, useFocusWithin } from "../../preact.js";
import { emptyPage, patientHere } from "../../shell/nobody.js";
import { StepBar } from "./step_bar.js";
import { calibrationStore, readCalibration } from "./store.js";
import { t } from "../../texts.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal: left }) {
  const here = patientHere(app, root);
  if (!here) return;
  const first = await readCalibration(app.api);
  if (left.aborted) return;
  const [{ steps }, { shirt }] = first;
  if (!shirt && steps.length === 1) {
    emptyPage(root, t("calibrate-no-shirt"), t("calibrate-no-shirt-lead"), "#/shirt", t("calibrate-no-shirt-go"));
    return;
  }
  const store = calibrationStore(app, here.patient.id, first, left);
  drawPage(root, h(Page, { store }));
  drawFoot(root, h(Foot, { store }));
}

/** @param {{store: CalibrationStore}} page */
function Page({ store }) {
  useFocusWithin(".body"); // another step is shown
  return h(
    Fragment,
    {},
    h(StepBar, { store }),
    store.step.value.kind === "result" ? h(CalibrationResult, { store }) : h(Step, { store }),
  );
}
