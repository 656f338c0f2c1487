/** What is missing before the chair can be armed, as a list of sentences. */
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";

/**
 * The page's own reasons come first: without a live link the server's may be out of date.
 * @param {import("../../live/live.js").Live} live @param {{refusals: string[]}} summary
 */
export function reasonsAgainst(live, { refusals }) {
  if (!live.connected || live.latest?.control !== "alive") return [t("arm-lost")];
  return [...new Set([...(live.latest.fault ? [t("arm-fault")] : []), ...refusals])];
}

export function missingList() {
  const element = h("section", { class: "missing", id: "missing", role: "status" });
  /** @type {string | null} */
  let shown = null;
  /** @param {string[]} reasons */
  const show = (reasons) => {
    const key = reasons.join("\n");
    if (key === shown) return;
    shown = key;
    element.classList.toggle("ready", !reasons.length);
    put(
      element,
      h("h2", {}, reasons.length ? t("arm-missing", { count: reasons.length }) : t("arm-ready")),
      reasons.length > 0 &&
        h(
          "ul",
          {},
          reasons.map((sentence) => h("li", {}, sentence)),
        ),
    );
  };
  return { element, show };
}
