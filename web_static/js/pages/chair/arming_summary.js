/**
 * What arming would apply: the set, its modes, the speeds that hold and why, and whether it was practised like this.
 * @import { ParametersSummary } from "types/api"
 * @import { Child } from "types/dom"
 * @import { FullReading, FullSummary } from "./arming.js"
 * @typedef {FullReading & {dial: number}} Application what arming would apply, and the dial's share
 * @typedef {[Child, Child, Child]} Row what, how it stands, remark
 */
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { field, selection } from "../../widgets/fields.js";
import { moment, number, percent } from "../../widgets/format.js";
import { SPEEDS, speedWords } from "../../widgets/speed_rows.js";
import { differenceWords } from "./difference_words.js";

const FIRST = new Set(["forward", "reverse", "turn"]); // what a person feels first; the others are folded away
const FINGERPRINT = 8; // digits that people compare
const EQUAL = 1e-6;

/**
 * `show` draws it again when something has changed.
 * @param {{onLoad: (title: string) => void, onPractise: () => void}} act
 */
export function armingSummary({ onLoad, onPractise }) {
  const place = h("div", { class: "stack" });
  const title = h("h2", {}, t("apply-card"));
  let shown = "";
  let isOpen = false;
  /** @param {Application} read */
  const show = (read) => {
    const key = JSON.stringify([read.summary, read.controls.saved, read.controls.hash, read.clinic, read.dial]);
    if (key === shown) return;
    shown = key;
    const more = h("details", { open: isOpen }, h("summary", {}, t("apply-more")), details(read));
    more.addEventListener("toggle", () => (isOpen = more.open));
    put(place, chosenSet(read, onLoad), main(read), practice(read.summary, onPractise), more);
  };
  return { element: h("section", { class: "card" }, title, place), title, show };
}

/** @param {Application} read @param {(title: string) => void} onLoad */
function chosenSet({ controls, summary }, onLoad) {
  const { title } = summary.parameters;
  const titles = [...new Set([title, ...controls.saved])];
  const change = h("a", { class: "btn bare small", href: "#/controls" }, t("apply-change"));
  if (titles.length === 1) return h("div", { class: "row" }, h("b", { class: "set-title" }, title), change);
  const select = selection(
    titles.map((one) => ({ value: one, label: one })),
    title,
    onLoad,
  );
  return h("div", { class: "row chosen-set" }, h("div", { class: "grow" }, field(t("apply-set"), select)), change);
}

/** @param {Application} read */
function main(read) {
  return [figures(read), how(read.summary.parameters)];
}

/** The speeds that a person feels first, in large figures. @param {Application} read */
function figures(read) {
  const shown = SPEEDS.filter(({ name }) => FIRST.has(name)).map((speed) => limit(speed, read));
  return h(
    "dl",
    { class: "first-speeds" },
    shown.map(([name, value, why]) =>
      h("div", {}, h("dt", {}, name), h("dd", { class: "number" }, value, why && h("small", {}, why))),
    ),
  );
}

/** @param {ParametersSummary} set */
function how({ mode_u1, mode_u2, cruise_time, turn_cruise_time }) {
  return rows(
    [t("apply-forward-back"), t(`how-u1-${mode_u1}`), t(`how-u1-${mode_u1}-hint`)],
    [t("apply-turning"), t(`how-u2-${mode_u2}`), t(`how-u2-${mode_u2}-hint`)],
    mode_u1 === "acceleration" && [t("apply-cruise"), t("apply-cruise-value", { time: number(cruise_time, 0) }), ""],
    mode_u2 === "acceleration" && [
      t("apply-turn-cruise"),
      t("apply-turn-cruise-value", { time: number(turn_cruise_time, 0) }),
      "",
    ],
  );
}

/** @param {Application} read */
function details(read) {
  const { cutoff, hash } = read.summary.parameters;
  return rows(
    ...SPEEDS.filter(({ name }) => !FIRST.has(name)).map((speed) => limit(speed, read)),
    [t("speed-cutoff"), `${number(cutoff, 1)} ${t("unit-cutoff")}`, ""],
    [t("apply-hash"), h("code", {}, hash.slice(0, FINGERPRINT)), t("apply-hash-hint")],
  );
}

/**
 * One limit, and the level that sets it where it is not the set's own.
 * @param {typeof SPEEDS[number]} speed @param {Application} read @returns {Row}
 */
function limit(speed, { summary, controls, clinic, chair, dial }) {
  const applied = summary.speeds[speed.name];
  const own = controls.parameters.speeds[speed.name];
  const levels = Math.min(clinic[speed.name], chair.speeds[speed.name]);
  let why = "";
  if (applied < Math.min(own, levels) - EQUAL) why = t("apply-level-dial", { share: percent(dial) });
  else if (applied < own - EQUAL) why = t(`apply-level-${clinic[speed.name] <= levels ? "clinic" : "chair"}`);
  return [t(`speed-${speed.name}`), speedWords(speed, applied), why];
}

/** @param {...(Row | false)} all */
function rows(...all) {
  return h(
    "dl",
    { class: "fact-list" },
    all.map((row) => {
      if (!row) return null;
      const [name, value, remark] = row;
      return h("div", {}, h("dt", {}, name), h("dd", { class: "number" }, value, remark && h("small", {}, remark)));
    }),
  );
}

/** @param {FullSummary} summary @param {() => void} onPractise */
function practice({ practised: { trials, last }, last_practised: before, differences }, onPractise) {
  if (trials > 0)
    return rows([
      t("apply-practised"),
      t("apply-practised-trials", { count: trials, when: last ? moment(last) : "" }),
      "",
    ]);
  return h(
    "div",
    { class: "unpractised" },
    h(
      "p",
      {},
      before && differences.length
        ? t("apply-differs", { title: before.title, hash: before.hash.slice(0, FINGERPRINT) })
        : t("apply-unpractised"),
    ),
    differences.length > 0 &&
      h(
        "ul",
        {},
        differences.map((difference) => h("li", {}, differenceWords(difference))),
      ),
    h("button", { type: "button", class: "btn small", onclick: onPractise }, t("apply-practise")),
  );
}
