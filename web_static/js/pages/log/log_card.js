/** Whether anybody changed the log, for the owner; checked when the page opens, and again on a tap. */
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";

/** @param {import("../../main.js").App} app @param {AbortSignal} signal */
export function logCard(app, signal) {
  const finding = h("p", { role: "status" });
  const problem = h("p", { class: "problem", role: "alert" });
  const again = h("button", { type: "button", class: "btn small" }, t("log-check"));
  const check = async () => {
    write(finding, t("log-checking"));
    write(problem, "");
    let whole = false;
    let message = "";
    try {
      ({ whole, message } = await app.api.get("/log/check"));
    } catch (error) {
      message = failureWords(error);
    }
    if (signal.aborted) return;
    write(finding, whole ? message : "");
    write(problem, whole ? "" : message);
  };
  again.addEventListener("click", check);
  check();
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("log-whole")),
    h("p", { class: "quiet small" }, t("log-whole-lead")),
    h("div", { class: "stack" }, h("div", {}, finding, problem), h("div", {}, again)),
  );
}
