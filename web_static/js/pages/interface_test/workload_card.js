/**
 * How demanding the test felt: six sliders of the NASA task load index, each of which may be left out.
 * @import { InterfaceTestView, Workload } from "types/api"
 */
import { failureWords } from "../../api.js";
import { h, useRef, useSignal } from "../../preact.js";
import { numberLimits, REFERENCE } from "../../reference.js";
import { t } from "../../texts.js";
import { number } from "../../widgets/format.js";

const STEP = 5;
const MIDDLE = 50; // where a slider stands that nobody has moved

/** The questions, as the server has them. */
const questions = () => /** @type {(keyof Workload)[]} */ (Object.keys(REFERENCE.limits.Workload));
const unanswered = () => Object.fromEntries(questions().map((name) => [name, null]));

/** @param {{app: import("../../main.js").App, test: InterfaceTestView}} card */
export function WorkloadCard({ app, test }) {
  const answers = useSignal(/** @type {Workload} */ ({ ...unanswered(), ...test.workload })); // null: left out
  const reply = useSignal(/** @type {InterfaceTestView | null} */ (null)); // what the server answered
  const problem = useSignal("");
  const save = async () => {
    problem.value = "";
    try {
      reply.value = await app.api.put(`/interface-tests/${test.id}/workload`, answers.value);
    } catch (error) {
      problem.value = failureWords(error);
    }
  };
  return h(
    "section",
    { class: "card workload" },
    h("h2", {}, t("test-workload")),
    h("p", { class: "quiet" }, t("test-workload-lead")),
    h(
      "div",
      { class: "workload-questions" },
      questions().map((name) =>
        h(Question, {
          key: name,
          name,
          answer: answers.value[name],
          onAnswer: (answer) => (answers.value = { ...answers.value, [name]: answer }),
        }),
      ),
    ),
    h("p", { class: "problem", role: "alert" }, problem.value),
    h(
      "div",
      { class: "spread" },
      h("button", { type: "button", class: "btn", onClick: save }, t("test-workload-save")),
      h(
        "p",
        { class: "quiet", role: "status" },
        reply.value ? `${t("test-workload-saved")} ${sum(reply.value)}` : sum(test),
      ),
    ),
  );
}

/** @param {{name: keyof Workload, answer: number | null, onAnswer: (answer: number | null) => void}} question */
function Question({ name, answer, onAnswer }) {
  const input = useRef(/** @type {HTMLInputElement | null} */ (null));
  const id = `workload-${name}`;
  const words = answer === null ? t("test-workload-none") : String(answer);
  const read = () => onAnswer(Number(input.current?.value));
  const leaveOut = () => {
    onAnswer(null);
    input.current?.focus();
  };
  return h(
    "div",
    { class: "workload-question" },
    h(
      "div",
      { class: "row" },
      h("label", { for: id }, t(`test-workload-${name}`)),
      h("output", { for: id, class: "number" }, words),
    ),
    h("input", {
      type: "range",
      id,
      ...numberLimits("Workload", name),
      step: STEP,
      class: answer === null ? "unanswered" : undefined,
      value: String(answer ?? MIDDLE),
      "aria-describedby": `${id}-ends`,
      "aria-valuetext": words,
      ref: input,
      onInput: read,
      onClick: read, // a tap on the middle, where the slider stands already, is an answer too
    }),
    h(
      "div",
      { class: "row small quiet", id: `${id}-ends` },
      h("span", {}, t(`test-workload-low-${name === "performance" ? name : "other"}`)),
      h("span", {}, t(`test-workload-high-${name === "performance" ? name : "other"}`)),
    ),
    h(
      "button",
      {
        type: "button",
        class: "btn small bare",
        hidden: answer === null,
        "aria-label": t("test-workload-clear", { question: t(`test-workload-${name}`) }),
        onClick: leaveOut,
      },
      t("test-workload-leave-out"),
    ),
  );
}

/** @param {InterfaceTestView} test */
function sum({ raw_tlx: mean }) {
  return mean === null ? "" : t("test-workload-sum", { value: number(mean, 0) });
}
