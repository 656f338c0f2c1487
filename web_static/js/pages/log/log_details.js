/**
 * The details of a row of the log in words: patients by their code, limits in the units of the other pages, changes as
 * "before → now", nothing that is empty.
 */
import { entryOf, nameOf, withUnit } from "../../results/measures.js";
import { hasText, t } from "../../texts.js";
import { day, moment, percent, size, unrounded } from "../../widgets/format.js";
import { jointWithin, sensorWithin } from "../../widgets/joint_words.js";
import { SPEEDS } from "../../widgets/speed_rows.js";
import { differenceWords } from "../chair/difference_words.js";

/** @typedef {Record<string, unknown>} Details */

/** Values that are no plain text or number, by the name of the detail. @type {Record<string, (value: string & number) => string>} */
const WRITTEN = {
  given: day,
  made: moment,
  since: moment,
  bytes: size,
  size,
  felt_change: percent,
  joint: jointWords,
  role: roleWords,
  unused: sensorWithin,
};
const PATIENTS = "patients"; // whom a person may see: all where there is no list
const MEASURED_AGAIN = "trial measured again"; // what differs are measures
const DIAL = "dial turned"; // its `share` is that of the speeds; elsewhere it is the id of a share link

/** What happened, in the words of the other pages. @param {string} what as the log has it */
export function whatWords(what) {
  const key = `log-what-${what}`;
  return hasText(key) ? t(key) : what;
}

/**
 * @param {Details} details @param {Map<number, string>} codes of patients, by id @param {string} [what] happened
 * @returns {string}
 */
export function detailWords(details, codes, what = "") {
  const { before, now, share, ...rest } = details;
  const differing = what === MEASURED_AGAIN ? measuredAgain : changed;
  const changes = isObject(before) && isObject(now) ? differing(before, now, codes) : facts({ before, now }, codes);
  const shares = what === DIAL ? [t("log-dial", { share: percent(Number(share)) })] : facts({ share }, codes);
  return [...facts(rest, codes), ...shares, ...changes].join(" · ");
}

/** @param {Details} details @param {Map<number, string>} codes @returns {string[]} */
function facts(details, codes) {
  return Object.entries(details)
    .filter(([, value]) => value !== null && value !== undefined && value !== "")
    .map(([name, value]) => {
      if (name === "patient") return codes.get(Number(value)) ?? t("log-detail-patient", { number: Number(value) });
      return t("log-detail", { name: nameWords(name), value: valueWords(name, value, codes) });
    });
}

/** What differs: a limit as on other pages, anything else as "name: before → now". @param {Details} before @param {Details} now @param {Map<number, string>} codes */
function changed(before, now, codes) {
  return Object.keys({ ...before, ...now })
    .filter((name) => JSON.stringify(before[name]) !== JSON.stringify(now[name]))
    .map((name) => {
      const [old, fresh] = [before[name], now[name]];
      if (SPEEDS.some((speed) => speed.name === name) && typeof old === "number" && typeof fresh === "number")
        return differenceWords({ kind: "field", name, before: old, now: fresh }).replace(/\.$/, "");
      return `${nameWords(name)}: ${valueWords(name, old, codes)} → ${valueWords(name, fresh, codes)}`;
    });
}

/** Which measures differ: "name: before → now", with all digits where fewer would hide it. @param {Details} before @param {Details} now */
function measuredAgain(before, now) {
  return Object.keys(before).map((name) => {
    const values = [before[name], now[name]];
    const [old, fresh] = values.map((value) => measureWords(name, value));
    return `${nameOf(name)}: ${old === fresh ? values.map(unroundedWords).join(" → ") : `${old} → ${fresh}`}`;
  });
}

/** @param {string} name of a measure @param {unknown} value */
function measureWords(name, value) {
  return typeof value === "number" && entryOf(name) ? withUnit(name, value) : unroundedWords(value);
}

/** @param {unknown} value of a measure */
function unroundedWords(value) {
  return typeof value === "number" ? unrounded(value) : t("log-value-none");
}

/** @param {string} name of a joint */
function jointWords(name) {
  return jointWithin({ name, label: name.replaceAll("_", " ") });
}

/** @param {string} name of a role */
function roleWords(name) {
  const key = `people-role-${name}`;
  return hasText(key) ? t(key) : name;
}

/** @param {string} name of a detail */
function nameWords(name) {
  const key = `log-name-${name}`;
  return hasText(key) ? t(key) : name.replaceAll("_", " ");
}

/** @param {string} name of the detail @param {unknown} value @param {Map<number, string>} codes @returns {string} */
function valueWords(name, value, codes) {
  if (name === PATIENTS && value === null) return t("log-value-every-patient");
  if (value === null || value === undefined) return t("log-value-none");
  if (typeof value === "boolean") return t(value ? "log-value-yes" : "log-value-no");
  if (Array.isArray(value))
    return (
      value.map((one) => (name === PATIENTS && codes.get(Number(one))) || valueWords(name, one, codes)).join(", ") ||
      t("log-value-none")
    );
  if (isObject(value))
    return Object.entries(value)
      .map(([inner, one]) => t("log-detail", { name: nameWords(inner), value: valueWords(inner, one, codes) }))
      .join(", ");
  const key = `log-value-${name}-${value}`;
  if (hasText(key)) return t(key);
  if (name in WRITTEN) return WRITTEN[name](/** @type {string & number} */ (value));
  if (typeof value === "number") return unrounded(value);
  return String(value);
}

/** @param {unknown} value @returns {value is Details} */
function isObject(value) {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}
