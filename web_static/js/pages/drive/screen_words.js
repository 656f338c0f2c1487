/**
 * How many screens the patient has, and what is not right with them.
 * @import { ScreensView } from "types/api"
 */
import { t } from "../../texts.js";

/** @param {ScreensView["screens"]} screens @returns {{words: string, isBad: boolean}} */
export function screenWords(screens) {
  const count = screens.length;
  if (!count) return { words: t("drive.screens.none"), isBad: false };
  if (screens.some(({ connected }) => !connected)) return { words: t("drive.screens.away", { count }), isBad: true };
  if (screens.some(({ picture }) => picture === "none")) return { words: t("drive.screens.bad", { count }), isBad: true };
  return { words: t("drive.screens", { count }), isBad: false };
}
