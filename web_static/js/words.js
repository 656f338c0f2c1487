/** Messages in Fluent (projectfluent.org): their text by id, in the language of the pages. */
import { FluentBundle, FluentNumber, FluentResource } from "../vendor/@fluent/bundle/index.js";
import { LANGUAGE } from "./language.js";

/** @typedef {Record<string, string | number | null | undefined>} Values */

const AS_WRITTEN = { useGrouping: false, maximumFractionDigits: 20 }; // of numbers: who gives one has rounded it
const PLACE = "\uFFFC"; // Unicode's sign for an object within a text
const MISSING = /\{\$\w+\}/g; // what stands for a value that was not given

/**
 * The texts of messages; `messages` is what a module of web_static/words/ has (app/api/pages.py).
 * @param {string} messages
 */
export function catalogue(messages) {
  const bundle = new FluentBundle(LANGUAGE, { useIsolating: false });
  bundle.addResource(new FluentResource(messages));

  /** @param {string} id */
  const find = (id) => bundle.getMessage(id) ?? bundle.getMessage(idOf(id));

  /**
   * Return the text of a message with its values put in, the id where there is none; no value stands for no words.
   * @param {string} id @param {Values} [values]
   */
  const t = (id, values = {}) => {
    const pattern = find(id)?.value;
    if (pattern == null) return id;
    /** @type {Error[]} */
    const errors = [];
    const text = bundle.formatPattern(pattern, argumentsOf(values), errors);
    return errors.length ? text.replace(MISSING, "") : text;
  };

  /**
   * Return the text of a message with a node in the place of one value, as children of an element.
   * @param {string} id @param {string} name of the value @param {Node} node @returns {(string | Node)[]}
   */
  const textWith = (id, name, node) => {
    const [before, after = ""] = t(id, { [name]: PLACE }).split(PLACE);
    return [before, node, after];
  };

  /** Tell whether there is a message of this id. @param {string} id */
  const hasText = (id) => find(id) !== undefined;

  return { t, textWith, hasText };
}

/**
 * The id that a part from elsewhere ("by hand", "u1+", "cross_talk") gives: letters, digits and single hyphens.
 * @param {string} text
 */
function idOf(text) {
  return text
    .replace(/\+$/, "-plus")
    .replace(/-$/, "-minus")
    .replace(/[^A-Za-z0-9]+/g, "-");
}

/** @param {Values} values */
function argumentsOf(values) {
  return Object.fromEntries(Object.entries(values).map(([name, value]) => [name, argumentOf(value)]));
}

/** @param {Values[string]} value */
function argumentOf(value) {
  if (typeof value !== "number") return value ?? "";
  return Number.isFinite(value) ? new FluentNumber(value + 0, AS_WRITTEN) : String(value); // -0 + 0 is 0
}
