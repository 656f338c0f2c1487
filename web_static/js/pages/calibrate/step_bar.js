/**
 * The steps of the calibration as a row with their names: which are done, which is shown, which has to be repeated.
 * @import { CalibrationStep } from "types/documents"
 * @import { IconName } from "../../widgets/icons.js"
 */
import { h } from "../../preact.js";
import { t } from "../../texts.js";
import { Icon } from "../../widgets/icons.js";
import { jointLabel } from "../../widgets/joint_words.js";

/** The icons that stand in place of a number, by the status of a step. @type {Record<string, IconName | undefined>} */
const ICONS = { done: "tick", failed: "undo" };

/** @param {{store: import("./store.js").CalibrationStore}} bar */
export function StepBar({ store: { calibration, step: shown, go, restart, chooseLength } }) {
  const { steps, running, short } = calibration.value;
  const hasBegun = steps.some(({ status }) => status === "done" || status === "failed");
  const hasChoice = short !== null && !hasBegun && !running;
  return h(
    "div",
    { class: "step-bar" },
    h(
      "ol",
      { class: "steps", "aria-label": t("calibrate-steps") },
      steps.map((step, index) =>
        h(
          "li",
          { key: step.id },
          h(StepButton, { step, index, isShown: step.id === shown.value.id, onClick: () => go(step.id) }),
        ),
      ),
    ),
    hasBegun && h("button", { type: "button", class: "btn bare small", onClick: restart }, t("result-restart")),
    hasChoice &&
      h(
        "button",
        { type: "button", class: "btn bare small", onClick: () => chooseLength(!short) },
        t(short ? "calibrate-whole" : "calibrate-short"),
      ),
  );
}

/** @param {{step: CalibrationStep, index: number, isShown: boolean, onClick: () => void}} button */
function StepButton({ step, index, isShown, onClick }) {
  const hasToBeRepeated = step.status === "done" && step.kind !== "result" && step.message !== ""; // but can be used
  const status = hasToBeRepeated ? "failed" : step.status;
  const name = step.joint ? jointLabel({ name: step.joint, label: step.label }) : step.label;
  const label = `${name}: ${t(`calibrate-step-${status}`)}`;
  const icon = ICONS[status];
  const sign = status === "skipped" ? "–" : String(index + 1);
  return h(
    "button",
    {
      type: "button",
      class: status,
      "aria-label": icon ? label : `${sign} ${label}`, // what is written is a part of the name
      title: step.title,
      "aria-current": isShown ? "step" : undefined,
      onClick,
    },
    h("span", {}, icon ? h(Icon, { name: icon, size: 16 }) : sign),
    " ", // between number and name, also for what reads them out
    h("small", {}, name),
  );
}
