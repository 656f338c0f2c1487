/** A measure from trial to trial as a small picture with its axis, for pages that do not load the large charts. */
import { Fragment, h } from "../preact.js";
import { t } from "../texts.js";
import { number } from "../widgets/format.js";

const [WIDTH, HEIGHT] = [340, 160]; // px of the picture, as long as it is not scaled
const [LEFT, RIGHT, TOP, BOTTOM] = [40, 12, 10, 24]; // px around the field
const INNER = LEFT + 20; // px to the first trial, so that its words are not cut
const ROUND = [1, 2, 2.5, 5, 10];

/**
 * @param {{trials: {number: number, value: number}[]}} curve trials: those that were measured, one at least, in their
 *   order; values from 0 up
 */
export function AreaCurve({ trials }) {
  const [first, last] = [trials[0].number, trials[trials.length - 1].number];
  const top = roundAbove(Math.max(...trials.map(({ value }) => value)));
  /** @param {number} trial */
  const x = (trial) =>
    last > first ? INNER + ((trial - first) / (last - first)) * (WIDTH - RIGHT - INNER - 20) : (INNER + WIDTH) / 2;
  /** @param {number} value */
  const y = (value) => HEIGHT - BOTTOM - (value / top) * (HEIGHT - TOP - BOTTOM);
  const digits = top < 1 ? 2 : top < 10 ? 1 : 0;
  /** @param {number} value */
  const mark = (value) =>
    h(
      Fragment,
      { key: value },
      h("line", { class: "axis", x1: LEFT, x2: WIDTH - RIGHT, y1: y(value), y2: y(value) }),
      h("text", { x: LEFT - 6, y: y(value) + 4, "text-anchor": "end" }, number(value, digits)),
    );
  return h(
    "svg",
    { class: "area-curve", viewBox: `0 0 ${WIDTH} ${HEIGHT}`, "aria-hidden": "true" },
    [0, top / 2, top].map(mark),
    [...new Set([first, last])].map((trial) =>
      h(
        "text",
        { key: trial, x: x(trial), y: HEIGHT - 6, "text-anchor": "middle" },
        t("compare-trial", { number: trial }),
      ),
    ),
    h("polyline", { class: "driven", points: trials.map((one) => `${x(one.number)},${y(one.value)}`).join(" ") }),
    trials.map((one) =>
      h("circle", { key: one.number, cx: x(one.number), cy: y(one.value), r: trials.length > 40 ? 2 : 4 }),
    ),
  );
}

/** The next round number that is not below a value; 1 for 0. @param {number} value */
function roundAbove(value) {
  if (value <= 0) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  return power * /** @type {number} */ (ROUND.find((times) => power * times >= value));
}
