/**
 * The question about an upload whose name is taken: a person keeps both, replaces the old one, or cancels.
 * @import { NameChoice } from "../api.js"
 * @typedef {"ask" | "keep-both" | "replace"} SameName
 */
import { REFERENCE } from "../reference.js";
import { ApiError } from "../api.js";
import { t } from "../texts.js";
import { h } from "./dom.js";
import { ask } from "./question.js";

/**
 * Send an upload; when its name is taken, ask and send it again.
 * @template Answer
 * @param {HTMLElement} place the page frame's, as of `questionPlace`
 * @param {(sameName: SameName) => Promise<Answer>} send
 * @returns {Promise<Answer | null>} the answer; null when the person cancelled
 */
export async function sendUnderName(place, send) {
  try {
    return await send("ask");
  } catch (error) {
    if (!(error instanceof ApiError && error.choice && "proposed" in error.choice)) throw error;
    const chosen = await choiceOf(place, error.message, error.choice);
    return chosen ? send(chosen) : null;
  }
}

/**
 * What the person chose; null when they cancelled.
 * @param {HTMLElement} place @param {string} question @param {NameChoice} choice @returns {Promise<SameName | null>}
 */
function choiceOf(place, question, { proposed, may_replace: mayReplace }) {
  /** @type {{value: SameName | null, label: string, kind?: string}[]} */
  const answers = [{ value: "keep-both", label: t("same-name-keep-both", { name: proposed }), kind: "btn go" }];
  if (mayReplace) answers.push({ value: "replace", label: t("same-name-replace") });
  answers.push({ value: null, label: t("cancel") });
  return ask(
    place,
    question,
    answers,
    mayReplace && h("p", { class: "quiet small" }, t("same-name-kept", { days: REFERENCE.numbers.replaced_days })),
  );
}
