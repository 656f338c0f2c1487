/**
 * How demanding the test felt: six sliders of the NASA task load index, each of which may be left out.
 * @import { InterfaceTestView } from "types/api"
 */
import { numberLimits } from "../../reference.js";
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, put, set, write } from "../../widgets/dom.js";
import { number } from "../../widgets/format.js";

const QUESTIONS = /** @type {const} */ (["mental", "physical", "temporal", "performance", "effort", "frustration"]);
const STEP = 5;
const MIDDLE = 50; // where a slider stands that nobody has moved

/** null: left out @typedef {Record<(typeof QUESTIONS)[number], number | null>} Answers */

/** @param {import("../../main.js").App} app @param {InterfaceTestView} test */
export function workloadCard(app, test) {
  /** @type {Answers} */
  const answers = {
    mental: null,
    physical: null,
    temporal: null,
    performance: null,
    effort: null,
    frustration: null,
    ...test.workload,
  };
  const problem = h("p", { class: "problem", role: "alert" });
  const status = h("p", { class: "quiet", role: "status" }, sum(test));
  const save = async () => {
    write(problem, "");
    try {
      const saved = await app.api.put(`/interface-tests/${test.id}/workload`, answers);
      write(status, `${t("test-workload-saved")} ${sum(saved)}`);
    } catch (error) {
      write(problem, failureWords(error));
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
      QUESTIONS.map((name) => question(name, answers)),
    ),
    problem,
    h(
      "div",
      { class: "spread" },
      h("button", { type: "button", class: "btn", onclick: save }, t("test-workload-save")),
      status,
    ),
  );
}

/** @param {(typeof QUESTIONS)[number]} name @param {Answers} answers */
function question(name, answers) {
  const id = `workload-${name}`;
  const value = h("output", { for: id, class: "number" });
  const input = h("input", {
    type: "range",
    id,
    ...numberLimits("Workload", name),
    step: STEP,
    "aria-describedby": `${id}-ends`,
  });
  const clear = h(
    "button",
    {
      type: "button",
      class: "btn small bare",
      "aria-label": t("test-workload-clear", { question: t(`test-workload-${name}`) }),
    },
    t("test-workload-leave-out"),
  );
  const show = () => {
    const answer = answers[name];
    const words = answer === null ? t("test-workload-none") : String(answer);
    input.classList.toggle("unanswered", answer === null);
    set(input, { "aria-valuetext": words });
    write(value, words);
    clear.hidden = answer === null;
  };
  input.value = String(answers[name] ?? MIDDLE);
  const take = () => {
    answers[name] = Number(input.value);
    show();
  };
  input.addEventListener("input", take);
  // A tap on the middle, where the slider stands already, is an answer too.
  input.addEventListener("click", take);
  clear.addEventListener("click", () => {
    answers[name] = null;
    input.value = String(MIDDLE);
    show();
    input.focus();
  });
  const [low, high] = [h("span", {}), h("span", {})];
  put(low, t(`test-workload-low-${name === "performance" ? name : "other"}`));
  put(high, t(`test-workload-high-${name === "performance" ? name : "other"}`));
  show();
  return h(
    "div",
    { class: "workload-question" },
    h("div", { class: "row" }, h("label", { for: id }, t(`test-workload-${name}`)), value),
    input,
    h("div", { class: "row small quiet", id: `${id}-ends` }, low, high),
    clear,
  );
}

/** @param {InterfaceTestView} test */
function sum({ raw_tlx: mean }) {
  return mean === null ? "" : t("test-workload-sum", { value: number(mean, 0) });
}
