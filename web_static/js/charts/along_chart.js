/**
 * One column of two trials over the way along the path, while motion was permitted.
 * @import { Timeline, TrialDetail } from "types/api"
 */
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { number } from "../widgets/format.js";
import { extent, limits } from "./extent.js";
import { chart } from "./plot.js";

/** Of the first and of the second trial. */
export const COLOURS = /** @type {const} */ (["path-driven", "action"]);

/**
 * @param {TrialDetail[]} trials @param {Timeline[]} lines @param {"v" | "across"} column
 * @param {string} label @param {string} axis @param {AbortSignal} signal
 */
export function alongChart(trials, lines, column, label, axis, signal) {
  const columns = lines.map((line) => {
    const points = line.t.flatMap((_, k) => {
      const [x, y] = [line.along[k], line[column][k]];
      return line.state[k] === REFERENCE.numbers.armed && x !== null && y !== null ? [{ x, y }] : [];
    });
    return { x: points.map(({ x }) => x), y: points.map(({ y }) => y) };
  });
  const [along, values] = [columns.flatMap(({ x }) => x), columns.flatMap(({ y }) => y)];
  const [from, to] = limits(along);
  return chart(label, signal, (colours) => ({
    x: { name: t("compare-along"), range: to > from ? [from, to] : undefined },
    y: { name: axis, range: extent(values, false) },
    series: columns.map(({ x, y }, i) => ({
      name: t("compare-trial", { number: trials[i].number }),
      x,
      y,
      line: { colour: colours[COLOURS[i]], width: 2, dash: i ? [8, 6] : undefined },
      words: (k) => `${number(x[k], 1)} m: ${number(y[k], 2)}`,
    })),
  }));
}
