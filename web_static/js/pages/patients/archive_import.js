/**
 * The import of a patient's archive from another clinic, for owners: a button, how far it is, and what came in.
 * @import { ImportedView } from "types/api"
 */
import { ApiError, failureWords } from "../../api.js";
import { createRef, h, signal } from "../../preact.js";
import { t } from "../../texts.js";
import { h as element } from "../../widgets/dom.js";
import { size } from "../../widgets/format.js";
import { ask } from "../../widgets/question.js";

const LOOK_EVERY = 1000; // ms

/**
 * The button that begins the import and, to stand elsewhere, its course.
 * @param {import("../../main.js").App} app @param {() => Promise<void>} onImported @param {AbortSignal} left
 */
export function archiveImport(app, onImported, left) {
  const input = /** @type {{current: HTMLInputElement | null}} */ (createRef());
  const result = signal({ message: "", problem: "" });
  const step = signal(/** @type {{words: string, share: number} | null} */ (null)); // null: nothing is imported
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
      const kept = element("p", { class: "quiet small" }, t("import-kept"));
      const chosen = await ask(app.question, error.message, answers, kept);
      return chosen && app.api.send(`/archives?${chosen}=true`, file);
    }
  };
  const look = async () => {
    const course = await app.api.get("/archives").catch(() => null);
    if (!step.value || !course?.total) return;
    const { step: name, done, total } = course;
    step.value = { words: t(`import-${name}`, { done: size(done), total: size(total) }), share: done / total };
  };
  /** @param {File} file */
  const run = async (file) => {
    result.value = { message: t("import-under-way", { name: file.name }), problem: "" };
    step.value = { words: "", share: 0 };
    const timer = setInterval(look, LOOK_EVERY);
    left.addEventListener("abort", () => clearInterval(timer));
    try {
      const imported = await send(file);
      if (imported) await onImported();
      result.value = { message: imported ? whatCameIn(imported) : "", problem: "" };
    } catch (error) {
      result.value = { message: "", problem: failureWords(error) };
    }
    clearInterval(timer);
    step.value = null;
  };
  /** @param {{currentTarget: HTMLInputElement}} event */
  const choose = ({ currentTarget }) => {
    const file = currentTarget.files?.[0];
    currentTarget.value = ""; // so that the same file can be chosen again
    if (file) run(file);
  };
  const ImportButton = () => {
    const isOff = step.value !== null;
    const press = () => void (isOff || input.current?.click());
    return h(
      "button",
      { type: "button", class: "btn", "aria-disabled": isOff || undefined, onClick: press },
      t("import-go"),
    );
  };
  const ImportCourse = () =>
    h(
      "div",
      { class: "above-list" },
      h("input", {
        type: "file",
        accept: ".zip,application/zip",
        class: "unseen",
        tabindex: -1,
        "aria-hidden": "true",
        ref: input,
        onChange: choose,
      }),
      h("p", { class: "quiet", role: "status" }, result.value.message),
      h(
        "div",
        { class: "measuring", hidden: step.value === null },
        h("p", { class: "number", "aria-hidden": "true" }, step.value?.words),
        h("progress", { max: 1, value: step.value?.share ?? 0, "aria-label": t("import-progress") }),
      ),
      h("p", { class: "problem", role: "alert" }, result.value.problem),
    );
  return { ImportButton, ImportCourse };
}

/** @param {ImportedView} imported */
function whatCameIn({ code, is_new: isNew, sessions, trials, kept }) {
  if (!isNew && !kept) return t("import-known", { code });
  return kept ? t("import-replaced", { code, sessions, trials, kept }) : t("import-done", { code, sessions, trials });
}
