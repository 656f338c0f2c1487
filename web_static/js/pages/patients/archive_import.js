/**
 * The import of a patient's archive from another clinic, for owners: a button, how far it is, and what came in.
 * @import { ImportedView } from "types/api"
 */
import { ApiError, failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";
import { hiddenFileInput } from "../../widgets/fields.js";
import { size } from "../../widgets/format.js";
import { ask } from "../../widgets/question.js";

const LOOK_EVERY = 1000; // ms

/** @param {import("../../main.js").App} app @param {() => Promise<void>} onImported @param {AbortSignal} signal */
export function archiveImport(app, onImported, signal) {
  const words = h("p", { class: "quiet", role: "status" });
  const problem = h("p", { class: "problem", role: "alert" });
  const progress = importProgress(app, signal);
  /** Send the archive; when its patient is here, ask and send it again. @param {File} file */
  const send = async (file) => {
    try {
      return await app.api.send("/archives", file);
    } catch (error) {
      if (!(error instanceof ApiError && error.choice && "may_replace_patient" in error.choice)) throw error;
      const answers = [
        { value: /** @type {const} */ ("replace"), label: t("import-replace") },
        { value: null, label: t("cancel"), kind: "btn go" },
      ];
      const chosen = await ask(
        app.question,
        error.message,
        answers,
        h("p", { class: "quiet small" }, t("import-kept")),
      );
      return chosen && app.api.send(`/archives?${chosen}=true`, file);
    }
  };
  const button = h("button", { type: "button", class: "btn", onclick: () => input.click() }, t("import-go"));
  const input = hiddenFileInput(".zip,application/zip", async (file) => {
    input.value = ""; // so that the same file can be chosen again
    button.disabled = true;
    write(problem, "");
    write(words, t("import-under-way", { name: file.name }));
    progress.begin();
    try {
      const imported = await send(file);
      if (imported) await onImported();
      write(words, imported ? whatCameIn(imported) : "");
    } catch (error) {
      write(words, "");
      write(problem, failureWords(error));
    }
    progress.end();
    button.disabled = false;
  });
  return { button, course: h("div", { class: "above-list" }, input, words, progress.element, problem) };
}

/** @param {ImportedView} imported */
function whatCameIn({ code, is_new: isNew, sessions, trials, kept }) {
  if (!isNew && !kept) return t("import-known", { code });
  return kept ? t("import-replaced", { code, sessions, trials, kept }) : t("import-done", { code, sessions, trials });
}

/** How far the import is, in figures and as a bar. @param {import("../../main.js").App} app @param {AbortSignal} signal */
function importProgress(app, signal) {
  const step = h("p", { class: "number", "aria-hidden": "true" });
  const bar = h("progress", { max: 1, value: 0, "aria-label": t("import-progress") });
  const element = h("div", { class: "measuring", hidden: true }, step, bar);
  let timer = 0;
  const look = async () => {
    const course = await app.api.get("/archives").catch(() => null);
    if (element.hidden || signal.aborted) return;
    if (course?.total) {
      const { step: name, done, total } = course;
      write(step, t(`import-${name}`, { done: size(done), total: size(total) }));
      bar.value = done / total;
    }
    timer = setTimeout(look, LOOK_EVERY);
  };
  const begin = () => {
    write(step, "");
    bar.value = 0;
    element.hidden = false;
    timer = setTimeout(look, LOOK_EVERY);
  };
  const end = () => {
    element.hidden = true;
    clearTimeout(timer);
  };
  signal.addEventListener("abort", end);
  return { element, begin, end };
}
