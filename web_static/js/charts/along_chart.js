/**
 * One column of two trials over the way along the path, while motion was permitted.
 * @import { Timeline, TrialDetail } from "types/api"
 */
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { chart } from "./plotly.js";

/** Of the first and of the second trial. */
export const COLOURS = /** @type {const} */ (["path-driven", "action"]);

/**
 * @param {TrialDetail[]} trials @param {Timeline[]} lines @param {"v" | "across"} column
 * @param {string} label @param {string} axis @param {AbortSignal} signal
 */
export function alongChart(trials, lines, column, label, axis, signal) {
  return chart(label, signal, (colours) => ({
    traces: lines.map((line, i) => {
      const armed = line.t.map((_, k) => k).filter((k) => line.state[k] === REFERENCE.numbers.armed);
      return {
        mode: "lines",
        x: armed.map((k) => line.along[k]),
        y: armed.map((k) => line[column][k]),
        name: t("compare-trial", { number: trials[i].number }),
        line: { color: colours[COLOURS[i]], width: 2, dash: i ? "dash" : "solid" },
        hovertemplate: `%{x:.1f} m: %{y:.2f}<extra></extra>`,
      };
    }),
    layout: { xaxis: { title: { text: t("compare-along") } }, yaxis: { title: { text: axis } } },
  }));
}
