/** The import of a patient's archive from another clinic, for owners: a button, and what becomes of it. */
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";
import { hiddenFileInput } from "../../widgets/fields.js";

/** @param {import("../../main.js").App} app @param {() => Promise<void>} onImported */
export function archiveImport(app, onImported) {
  const words = h("p", { class: "quiet", role: "status" });
  const problem = h("p", { class: "problem", role: "alert" });
  const button = h("button", { type: "button", class: "btn", onclick: () => input.click() }, t("import.go"));
  const input = hiddenFileInput(".zip,application/zip", async (file) => {
    input.value = ""; // so that the same file can be chosen again
    button.disabled = true;
    write(problem, "");
    write(words, t("import.under-way", { name: file.name }));
    try {
      const { code, is_new: isNew } = await app.api.send("/archives", file);
      app.toasts.show(t(isNew ? "import.done" : "import.known", { code }));
      await onImported();
    } catch (error) {
      write(problem, failureWords(error));
    }
    write(words, "");
    button.disabled = false;
  });
  return { button, course: h("div", { class: "above-list" }, input, words, problem) };
}
