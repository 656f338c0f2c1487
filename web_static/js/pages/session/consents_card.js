/**
 * The consents of a patient: each with its day, a form to enter it, and a button to withdraw it.
 * @import { ConsentsView, ConsentView } from "types/api"
 */
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { field } from "../../widgets/fields.js";
import { day } from "../../widgets/format.js";
import { today } from "./scales_card.js";

/** @param {import("../../main.js").App} app @param {ConsentsView} found @param {(now: ConsentsView) => void} onChange */
export function consentsCard(app, found, onChange) {
  const mayChange = app.me?.role === "owner" || app.me?.role === "clinician";
  const list = h("div", { class: "stack" });
  /** @param {() => Promise<ConsentsView>} act @param {string} consent that gets the focus back */
  const change = async (act, consent) => {
    try {
      found = await act();
    } catch (error) {
      return app.toasts.show(failureWords(error));
    }
    draw();
    onChange(found);
    /** @type {HTMLElement | null} */ (list.querySelector(`[data-consent="${consent}"] button`))?.focus();
  };
  /** @param {ConsentView} one */
  const row = (one) => {
    const { consent, given, history } = one;
    const name = t(`consent-${consent}`);
    const path = /** @type {const} */ (`/patients/${found.patient_id}/consents/${consent}`);
    const date = h("input", { type: "date", required: true });
    date.defaultValue = date.value = today();
    date.max = today();
    /** @param {SubmitEvent} event */
    const give = (event) => {
      event.preventDefault();
      change(() => app.api.put(path, { given: date.value }), consent);
    };
    const past = history.filter(({ withdrawn }) => withdrawn);
    return h(
      "section",
      { class: "consent", "data-consent": consent },
      h(
        "div",
        { class: "grow" },
        h("h3", {}, name),
        h("p", { class: "quiet small" }, t(`consent-${consent}-hint`)),
        h("p", {}, standWords(one)),
      ),
      mayChange &&
        !given &&
        h(
          "form",
          { class: "spread consent-form", onsubmit: give },
          field(t("consent-day"), date),
          h("button", { class: "btn", "aria-label": t("consent-give-label", { consent: name }) }, t("consent-give")),
        ),
      mayChange &&
        given &&
        h(
          "button",
          {
            type: "button",
            class: "btn",
            "aria-label": t("consent-withdraw-label", { consent: name }),
            onclick: () => change(() => app.api.remove(path), consent),
          },
          t("consent-withdraw"),
        ),
      past.length > 0 &&
        h(
          "details",
          {},
          h("summary", {}, t("consent-history")),
          past.map(({ given: from, withdrawn, withdrawn_by: person }) =>
            h("p", { class: "quiet small" }, t("consent-past", { day: day(from), withdrawn: day(withdrawn), person })),
          ),
        ),
    );
  };
  const draw = () => put(list, found.consents.map(row));
  draw();
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("consent-title")),
    h("p", { class: "quiet" }, t("consent-lead")),
    list,
  );
}

/** @param {ConsentView} one */
function standWords({ given, history }) {
  if (!given) return t("consent-off");
  const person = history.find(({ withdrawn }) => !withdrawn)?.person;
  return t("consent-by", { day: day(given), person });
}
