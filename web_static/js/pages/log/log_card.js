/** Whether anybody changed the log, for the owner; checked when the page opens, and again on a tap. */
import { failureWords } from "../../api.js";
import { h, useLayoutEffect, useSignal } from "../../preact.js";
import { t } from "../../texts.js";

/** @param {{app: import("../../main.js").App}} card */
export function LogCard({ app }) {
  const finding = useSignal({ whole: true, message: "" });
  const check = async () => {
    finding.value = { whole: true, message: t("log-checking") };
    finding.value = await app.api.get("/log/check").catch((error) => ({ whole: false, message: failureWords(error) }));
  };
  useLayoutEffect(() => void check(), []);
  const { whole, message } = finding.value;
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("log-whole")),
    h("p", { class: "quiet small" }, t("log-whole-lead")),
    h(
      "div",
      { class: "stack" },
      h(
        "div",
        {},
        h("p", { role: "status" }, whole && message),
        h("p", { class: "problem", role: "alert" }, !whole && message),
      ),
      h("div", {}, h("button", { type: "button", class: "btn small", onClick: check }, t("log-check"))),
    ),
  );
}
