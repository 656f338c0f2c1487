/**
 * The card over a page whose session is no longer open: who is here now, whose page this is, and where to go.
 * @import { CurrentSession } from "types/api"
 */
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";
import { minuteOfDay } from "../widgets/format.js";
import { icon } from "../widgets/icons.js";

/** The reason with which the page of an earlier session ends: it sends nothing more. */
export const OTHER_SESSION = "other session";

const FIELDS = "form :is(input:not([type=radio], [type=hidden], [type=file]), textarea)";

/**
 * @param {CurrentSession} before the session that the page shows @param {CurrentSession} now the session that is open
 * @param {string[]} drafts what was entered and not sent
 * @param {{onGo: () => void}} actions
 */
export function otherSession(before, now, drafts, { onGo }) {
  const codeBefore = before.patient?.code ?? "";
  const belongs = t("session-belongs", { code: codeBefore });
  const sentence = now.patient
    ? t(now.session?.opened_by ? "session-opened" : "session-opened-somebody", {
        code: now.patient.code,
        name: now.session?.opened_by ?? "",
        time: now.session ? minuteOfDay(now.session.started) : "",
      })
    : t("session-ended", { code: codeBefore });
  const title = h("h1", { id: "other-session", tabindex: "-1" }, t("session-other"));
  const element = h(
    "main", // the page beneath is off
    { class: "other-session" },
    h(
      "div",
      {
        class: "card",
        role: "alertdialog",
        "aria-labelledby": "other-session",
        "aria-describedby": "other-session-why",
      },
      icon("warning", 32),
      title,
      h("p", { class: "lead", id: "other-session-why" }, `${sentence} ${belongs}`),
      drafts.length > 0 && [
        h("p", {}, t("session-drafts")),
        h(
          "ul",
          {},
          drafts.map((draft) => h("li", {}, draft)),
        ),
      ],
      h(
        "div",
        { class: "spread" },
        now.patient &&
          h("button", { type: "button", class: "btn go", onclick: onGo }, t("session-go", { code: now.patient.code })),
        h("a", { class: now.patient ? "btn" : "btn go", href: "#/patients" }, t("session-patients")),
      ),
    ),
  );
  return { element, focus: () => title.focus({ preventScroll: true }) };
}

/** The labels of the fields that a person changed in the page's forms. @param {HTMLElement} root @returns {string[]} */
export function changedFields(root) {
  /** @type {NodeListOf<HTMLInputElement>} */
  const fields = root.querySelectorAll(FIELDS); // or HTMLTextAreaElement, which has the same members but `checked`
  return [...fields]
    .filter((field) =>
      field.type === "checkbox" ? field.checked !== field.defaultChecked : field.value !== field.defaultValue,
    )
    .map((field) => {
      const label = field.labels?.[0]?.textContent ?? field.getAttribute("aria-label") ?? "";
      return field.type === "checkbox" ? label : t("session-draft", { label, value: field.value });
    });
}
