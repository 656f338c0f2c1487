/** How far an export is that was begun by a link: words and a bar, asked for by a word that the link carries. */
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";
import { size } from "../../widgets/format.js";

const ASK_EVERY = 1000; // ms
const MOST_UNKNOWN = 30; // answers in which the export has not begun: then it was refused, and the browser says why

/** @param {import("../../main.js").App} app */
export function exportProgress(app) {
  const words = h("p", { class: "number", role: "status" });
  const bar = h("progress", { max: 1, value: 0, "aria-label": t("export-progress") });
  const element = h("div", { class: "measuring", hidden: true }, words, bar);
  let timer = 0;
  /** @param {string} word @param {number} unknown answers so far */
  const look = async (word, unknown) => {
    const course = await app.api.get(`/exports?course=${word}`).catch(() => null);
    if (!element.isConnected) return;
    if (!course) {
      element.hidden = unknown >= MOST_UNKNOWN;
      if (!element.hidden) timer = setTimeout(() => look(word, unknown + 1), ASK_EVERY);
      return;
    }
    const { packed, recordings, sent, state } = course;
    const figures = { packed, recordings, size: size(sent) };
    bar.hidden = state !== "going on";
    bar.value = recordings ? packed / recordings : 0;
    write(words, t(`export-state-${state}`, figures));
    if (state === "going on") timer = setTimeout(() => look(word, unknown), ASK_EVERY);
  };
  /** Begin to ask, and return the word that the link of the export is to carry. */
  const begin = () => {
    const word = crypto.randomUUID();
    clearTimeout(timer);
    bar.value = 0;
    bar.hidden = false;
    element.hidden = false;
    write(words, t("export-begun"));
    timer = setTimeout(() => look(word, 0), ASK_EVERY);
    return word;
  };
  return { element, begin };
}
