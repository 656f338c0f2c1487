/**
 * Two trials of the list, chosen to be compared.
 * @import { TrialView } from "types/api"
 */
import { t } from "../../texts.js";
import { h, set, write } from "../../widgets/dom.js";

/**
 * A box for each trial, and the link that compares the two that are ticked; a third takes the place of the first.
 * @param {number} patient id @returns {{element: HTMLElement, box: (trial: TrialView) => HTMLElement}}
 */
export function compareChoice(patient) {
  /** @type {{trial: TrialView, input: HTMLInputElement}[]} */
  let chosen = [];
  const link = h("a", { class: "btn" }, t("compare-go"));
  const words = h("span", { class: "quiet", role: "status" });
  const show = () => {
    const ready = chosen.length === 2;
    const [first, second] = chosen.map(({ trial }) => trial).sort((a, b) => a.id - b.id);
    set(link, {
      href: ready ? `#/review/${patient}/compare/${first.id}/${second.id}` : null,
      "aria-disabled": ready ? null : "true",
    });
    write(
      words,
      ready
        ? t("compare-chosen", { first: first.number, second: second.number })
        : t("compare-choose", { count: 2 - chosen.length }),
    );
  };
  /** @param {TrialView} trial @param {HTMLInputElement} input */
  const change = (trial, input) => {
    chosen = chosen.filter((one) => one.trial.id !== trial.id);
    if (input.checked) chosen.push({ trial, input });
    if (chosen.length > 2) {
      chosen[0].input.checked = false;
      chosen = chosen.slice(1);
    }
    show();
  };
  /** @param {TrialView} trial */
  const box = (trial) => {
    const input = h("input", { type: "checkbox", "aria-label": t("compare-pick", { number: trial.number }) });
    const before = chosen.find((one) => one.trial.id === trial.id); // the list was drawn anew
    if (before) before.input = input;
    input.checked = before !== undefined;
    input.addEventListener("change", () => change(trial, input));
    return h("label", { class: "pick" }, input);
  };
  show();
  return { element: h("div", { class: "spread compare-choice" }, link, words), box };
}
