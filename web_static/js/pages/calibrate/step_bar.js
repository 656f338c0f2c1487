/** The steps of the calibration as a row with their names: which are done, which is shown, which has to be repeated. */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { icon } from "../../widgets/icons.js";
import { jointLabel } from "../../widgets/joint_words.js";

/**
 * @param {import("types/documents").CalibrationStep[]} steps @param {string} current @param {(id: string) => void} onGo @param {() => void} onRestart
 */
export function stepBar(steps, current, onGo, onRestart) {
  const list = h(
    "ol",
    { class: "steps", "aria-label": t("calibrate-steps") },
    steps.map((step, index) => {
      const status = step.status === "done" && step.kind !== "result" && step.message ? "failed" : step.status; // it can be used, but has to be repeated
      const name = step.joint ? jointLabel({ name: step.joint, label: step.label }) : step.label;
      const label = `${name}: ${t(`calibrate-step-${status}`)}`;
      /** @type {Record<string, Node | string>} */
      const marks = { done: icon("tick", 16), failed: icon("undo", 16), skipped: "–" };
      const mark = marks[status] ?? String(index + 1);
      return h(
        "li",
        {},
        h(
          "button",
          {
            type: "button",
            class: status,
            "aria-label": typeof mark === "string" ? `${mark} ${label}` : label, // what is written is a part of the name
            title: step.title,
            "aria-current": step.id === current ? "step" : null,
            onclick: () => onGo(step.id),
          },
          h("span", {}, mark),
          " ", // between number and name, also for what reads them out
          h("small", {}, name),
        ),
      );
    }),
  );
  const hasBegun = steps.some(({ status }) => status === "done" || status === "failed");
  return h(
    "div",
    { class: "step-bar" },
    list,
    hasBegun && h("button", { type: "button", class: "btn bare small", onclick: onRestart }, t("result-restart")),
  );
}
