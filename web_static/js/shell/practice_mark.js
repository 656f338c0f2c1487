/** The mark of a shirt that nobody wears: every page carries it while one is in use. */
import { hasText, t } from "../texts.js";
import { h, write } from "../widgets/dom.js";

/** The mark; `show` takes the kind of that shirt, null when somebody wears it or when there is none. */
export function practiceMark() {
  const words = h("b", {});
  const element = h(
    "span",
    { class: "practice", role: "status", hidden: true },
    words,
    " ",
    h("span", {}, t("practice-only")),
  );
  /** @param {string | null} kind */
  const show = (kind) => {
    if (kind) write(words, hasText(`practice-${kind}`) ? t(`practice-${kind}`) : t("practice-other"));
    element.hidden = !kind;
  };
  return { element, show };
}

/** Ask for the kind, for pages without a live picture. @param {import("../api.js").Api} api @returns {Promise<string | null>} */
export async function readPractice(api) {
  return (await api.get("/equipment/practice")).kind;
}
