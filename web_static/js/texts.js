/**
 * Every text of the pages, by key. A language is a folder beside this file; English is the first and the fall-back.
 * A text may hold {values}; a text of the form {one, other} is chosen by the value `count`.
 */
import { LANGUAGE } from "./language.js";
import adapt from "./texts/en/adapt.js";
import attention from "./texts/en/sharing/attention.js";
import backup from "./texts/en/records/backup.js";
import calibrate from "./texts/en/calibrate.js";
import chair from "./texts/en/chair.js";
import computer from "./texts/en/computer.js";
import controls from "./texts/en/controls.js";
import discovery from "./texts/en/discovery.js";
import drive from "./texts/en/drive.js";
import editor from "./texts/en/editor.js";
import record_export from "./texts/en/records/export.js";
import log from "./texts/en/records/log.js";
import interface_test from "./texts/en/results/interface_test.js";
import measures from "./texts/en/measures.js";
import patient_screen from "./texts/en/patient_screen.js";
import patients from "./texts/en/patients.js";
import people from "./texts/en/people.js";
import picture from "./texts/en/picture.js";
import records_session from "./texts/en/records/session.js";
import replay from "./texts/en/replay.js";
import quality from "./texts/en/quality.js";
import review from "./texts/en/review.js";
import settings from "./texts/en/settings.js";
import comments from "./texts/en/sharing/comments.js";
import share from "./texts/en/sharing/share.js";
import share_links from "./texts/en/sharing/share_links.js";
import shell from "./texts/en/shell.js";
import shirt from "./texts/en/shirt.js";
import stereo from "./texts/en/stereo.js";
import uploads from "./texts/en/uploads.js";
import verdict from "./texts/en/results/verdict.js";

/** @typedef {string | {one?: string, other: string}} Text */

/** @type {Readonly<Record<string, Text>>} */
const CATALOGUE = Object.freeze({
  ...attention,
  ...comments,
  ...share,
  ...share_links,
  ...shell,
  ...patients,
  ...shirt,
  ...calibrate,
  ...computer,
  ...controls,
  ...adapt,
  ...backup,
  ...discovery,
  ...drive,
  ...editor,
  ...record_export,
  ...log,
  ...chair,
  ...interface_test,
  ...measures,
  ...quality,
  ...records_session,
  ...review,
  ...replay,
  ...picture,
  ...settings,
  ...patient_screen,
  ...people,
  ...stereo,
  ...uploads,
  ...verdict,
});
const PLURALS = new Intl.PluralRules(LANGUAGE);

/**
 * Return a text with its values put in.
 * @param {string} key @param {Record<string, string | number | null | undefined>} [values] @returns {string}
 */
export function t(key, values = {}) {
  const found = CATALOGUE[key];
  if (found === undefined) return key;
  const text = typeof found === "string" ? found : formOf(found, Number(values.count));
  return text.replace(/\{(\w+)\}/g, (_, name) => String(values[name] ?? ""));
}

/** @param {Exclude<Text, string>} forms @param {number} count */
function formOf(forms, count) {
  return PLURALS.select(count) === "one" ? (forms.one ?? forms.other) : forms.other;
}

/** Tell whether there is a text of this key. @param {string} key */
export function hasText(key) {
  return key in CATALOGUE;
}
