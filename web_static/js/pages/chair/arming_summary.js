/**
 * What arming would apply: the set, its modes, the speeds that hold and why, and whether it was practised like this.
 * @import { ParametersSummary } from "types/api"
 * @import { Fact } from "../../widgets/fact_list.js"
 * @import { Application, ArmingStore, FullSummary } from "./store.js"
 */
import { h } from "../../preact.js";
import { t } from "../../texts.js";
import { FactList } from "../../widgets/fact_list.js";
import { Field, Selection } from "../../widgets/fields.js";
import { moment, number, percent } from "../../widgets/format.js";
import { SPEEDS, speedWords } from "../../widgets/speed_rows.js";
import { differenceWords } from "./difference_words.js";

const FIRST = new Set(["forward", "reverse", "turn"]); // what a person feels first; the others are folded away
const FINGERPRINT = 8; // digits that people compare
const EQUAL = 1e-6;

/** @param {{store: ArmingStore, step: number}} card step: its number before arming */
export function ArmingSummary({ store, step }) {
  const read = store.reading.value;
  return h(
    "section",
    { class: "card" },
    h("h2", {}, h("span", { class: "step-number" }, step), t("apply-card")),
    h(
      "div",
      { class: "stack" },
      h(ChosenSet, { read, onLoad: store.load }),
      h(FirstSpeeds, { read }),
      read.summary.crawls && h("p", { class: "crawls" }, t("apply-crawls")),
      h(FactList, { facts: modes(read.summary.parameters) }),
      h(Practice, { summary: read.summary, onPractise: store.chooseVirtual }),
      h("details", {}, h("summary", {}, t("apply-more")), h(FactList, { facts: details(read) })),
    ),
  );
}

/** @param {{read: Application, onLoad: (title: string) => void}} set */
function ChosenSet({ read: { controls, summary }, onLoad }) {
  const { title } = summary.parameters;
  const titles = [...new Set([title, ...controls.saved])];
  const change = h("a", { class: "btn bare small", href: "#/controls" }, t("apply-change"));
  if (titles.length === 1) return h("div", { class: "row" }, h("b", { class: "set-title" }, title), change);
  const options = titles.map((one) => ({ value: one, label: one }));
  const select = h(Selection, { options, chosen: title, onChange: onLoad });
  return h(
    "div",
    { class: "row chosen-set" },
    h("div", { class: "grow" }, h(Field, { label: t("apply-set") }, select)),
    change,
  );
}

/** The speeds that a person feels first, in large figures. @param {{read: Application}} speeds */
function FirstSpeeds({ read }) {
  const facts = SPEEDS.filter(({ name }) => FIRST.has(name)).map((speed) => limit(speed, read));
  return h(
    "dl",
    { class: "first-speeds" },
    facts.map(([name, value, why]) =>
      h("div", { key: name }, h("dt", {}, name), h("dd", { class: "number" }, value, why && h("small", {}, why))),
    ),
  );
}

/** @param {ParametersSummary} set @returns {Fact[]} */
function modes({ mode_u1, mode_u2, cruise_time, turn_cruise_time }) {
  /** @type {Fact[]} */
  const facts = [
    [t("apply-forward-back"), t(`how-u1-${mode_u1}`), t(`how-u1-${mode_u1}-hint`)],
    [t("apply-turning"), t(`how-u2-${mode_u2}`), t(`how-u2-${mode_u2}-hint`)],
  ];
  if (mode_u1 === "acceleration")
    facts.push([t("apply-cruise"), t("apply-cruise-value", { time: number(cruise_time, 0) })]);
  if (mode_u2 === "acceleration")
    facts.push([t("apply-turn-cruise"), t("apply-turn-cruise-value", { time: number(turn_cruise_time, 0) })]);
  return facts;
}

/** @param {Application} read @returns {Fact[]} */
function details(read) {
  const { document: chairDocument, hash, parameters } = read.summary;
  /** @type {Fact[]} */
  const ofChair = chairDocument
    ? [[t("apply-document"), h("code", {}, chairDocument.slice(0, FINGERPRINT)), t("apply-document-hint")]]
    : [];
  return [
    ...SPEEDS.filter(({ name }) => !FIRST.has(name)).map((speed) => limit(speed, read)),
    [t("speed-cutoff"), `${number(parameters.cutoff, 1)} ${t("unit-cutoff")}`],
    ...ofChair,
    [t("apply-hash"), h("code", {}, hash.slice(0, FINGERPRINT)), t("apply-hash-hint")],
  ];
}

/**
 * One limit, and the level that sets it where it is not the set's own.
 * @param {typeof SPEEDS[number]} speed @param {Application} read @returns {Fact}
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

/** @param {{summary: FullSummary, onPractise: () => void}} practice */
function Practice({ summary: { practised, last_practised: before, differences }, onPractise }) {
  const { trials, last } = practised;
  if (trials > 0) {
    const words = t("apply-practised-trials", { count: trials, when: last ? moment(last) : "" });
    return h(FactList, { facts: [[t("apply-practised"), words]] });
  }
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
        differences.map(differenceWords).map((words) => h("li", { key: words }, words)),
      ),
    h("button", { type: "button", class: "btn small", onClick: onPractise }, t("apply-practise")),
  );
}
