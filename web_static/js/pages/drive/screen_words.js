/**
 * How many screens the patient has, and what is not right with them.
 * @import { ScreensView } from "types/api"
 */
import { t } from "../../texts.js";

/** What is not right with the patient's screens. @param {ScreensView["screens"]} screens @returns {"" | "-none" | "-away" | "-bad"} */
export function screenState(screens) {
  if (!screens.length) return "-none";
  if (screens.some(({ connected }) => !connected)) return "-away";
  return screens.some(({ picture }) => picture === "none") ? "-bad" : "";
}

/** @param {ScreensView["screens"]} screens @returns {{words: string, isBad: boolean}} */
export function screenWords(screens) {
  const state = screenState(screens);
  return { words: t(`drive-screens${state}`, { count: screens.length }), isBad: state === "-away" || state === "-bad" };
}
