/**
 * The consents of a patient: each with its day, a form to enter it, and a button to withdraw it.
 * @import { ConsentsView, ConsentView } from "types/api"
 */
import { focusFirst, h, useRef } from "../../preact.js";
import { t } from "../../texts.js";
import { Field } from "../../widgets/fields.js";
import { day, today } from "../../widgets/format.js";
import { mayWrite } from "./store.js";

/** @param {{app: import("../../main.js").App, view: ConsentsView, onChange: (now: ConsentsView) => void}} card */
export function ConsentsCard({ app, view: { patient_id: patient, consents }, onChange }) {
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("consent-title")),
    h("p", { class: "quiet" }, t("consent-lead")),
    h(
      "div",
      { class: "stack" },
      consents.map((view) => h(Consent, { key: view.consent, app, patient, view, onChange })),
    ),
  );
}

/**
 * @param {object} row
 * @param {import("../../main.js").App} row.app @param {number} row.patient id @param {ConsentView} row.view
 * @param {(now: ConsentsView) => void} row.onChange
 */
function Consent({ app, patient, view, onChange }) {
  const wasChanged = useRef(false);
  const { consent, given, history } = view;
  const name = t(`consent-${consent}`);
  const path = /** @type {const} */ (`/patients/${patient}/consents/${consent}`);
  /** @param {() => Promise<ConsentsView>} act */
  const change = (act) =>
    app.toasts.attempt(async () => {
      const now = await act();
      wasChanged.current = true;
      onChange(now);
    });
  /** @param {SubmitEvent} event */
  const give = (event) => {
    event.preventDefault();
    const entries = new FormData(/** @type {HTMLFormElement} */ (event.currentTarget));
    change(() => app.api.put(path, { given: String(entries.get("given")) }));
  };
  // The button in place of the one that changed the consent has the focus.
  const button = { class: "btn", ref: wasChanged.current ? focusFirst : null };
  const past = history.filter(({ withdrawn }) => withdrawn);
  return h(
    "section",
    { class: "consent", "data-consent": consent },
    h(
      "div",
      { class: "grow" },
      h("h3", {}, name),
      h("p", { class: "quiet small" }, t(`consent-${consent}-hint`)),
      h("p", {}, stateWords(view)),
    ),
    mayWrite(app) &&
      !given &&
      h(
        "form",
        { class: "spread consent-form", onSubmit: give },
        h(
          Field,
          { label: t("consent-day") },
          h("input", { type: "date", name: "given", required: true, defaultValue: today(), max: today() }),
        ),
        h("button", { ...button, "aria-label": t("consent-give-label", { consent: name }) }, t("consent-give")),
      ),
    mayWrite(app) &&
      given &&
      h(
        "button",
        {
          ...button,
          type: "button",
          "aria-label": t("consent-withdraw-label", { consent: name }),
          onClick: () => change(() => app.api.remove(path)),
        },
        t("consent-withdraw"),
      ),
    past.length > 0 &&
      h(
        "details",
        {},
        h("summary", {}, t("consent-history")),
        past.map(({ given: from, withdrawn, withdrawn_by: person }) =>
          h(
            "p",
            { class: "quiet small", key: withdrawn },
            t("consent-past", { day: day(from), withdrawn: day(withdrawn), person }),
          ),
        ),
      ),
  );
}

/** @param {ConsentView} view */
function stateWords({ given, history }) {
  if (!given) return t("consent-off");
  const person = history.find(({ withdrawn }) => !withdrawn)?.person;
  return t("consent-by", { day: day(given), person });
}
