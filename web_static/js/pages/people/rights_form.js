/**
 * The form for a person's name and rights: role, and for a reviewer which patients.
 * @import { PatientView, PersonView } from "types/api"
 */
import { textLimits } from "../../reference.js";
import { failureWords } from "../../api.js";
import { h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Field, Segments } from "../../widgets/fields.js";

/** @typedef {PersonView["role"]} Role */
/** @typedef {typeof SHOWN[number]} Shown */
const ROLES = /** @type {const} */ (["clinician", "reviewer", "owner"]);
const SHOWN = /** @type {const} */ (["all", "chosen"]);

/**
 * @param {object} form
 * @param {PatientView[]} form.patients
 * @param {PersonView | null} form.person whose rights are changed; null: somebody new
 * @param {(rights: {name: string, role: Role, patients: number[] | null}) => Promise<void>} form.send
 * @param {() => void} form.onClose
 */
export function RightsForm({ patients, person, send, onClose }) {
  const role = useSignal(/** @type {Role} */ (person?.role ?? "clinician"));
  const shown = useSignal(/** @type {Shown} */ (person?.patients ? "chosen" : "all"));
  const problem = useSignal("");
  const isSending = useSignal(false); // a second tap would invite twice
  const isReviewer = role.value === "reviewer";
  const isRestricted = isReviewer && shown.value === "chosen";
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    if (isSending.value) return;
    const entries = new FormData(/** @type {HTMLFormElement} */ (event.currentTarget));
    const name = String(entries.get("name") ?? "").trim();
    problem.value = "";
    isSending.value = true;
    await send({ name, role: role.value, patients: isRestricted ? entries.getAll("patient").map(Number) : null }).catch(
      (error) => (problem.value = failureWords(error)),
    );
    isSending.value = false;
  };
  return h(
    "form",
    { class: "card stack", onSubmit: submit },
    h("h2", {}, person ? t("people-rights-title", { name: person.name }) : t("people-invite")),
    !person &&
      h(
        Field,
        {
          label: t("sign-in-name"),
          hint: t("people-name-hint"),
        },
        h("input", {
          type: "text",
          name: "name",
          required: true,
          ...textLimits("NewPerson", "name"),
          autocomplete: "off",
        }),
      ),
    h(Segments, {
      label: t("people-role"),
      options: ROLES.map((value) => ({ value, label: t(`people-role-${value}`) })),
      chosen: role.value,
      onChange: (/** @type {Role} */ value) => (role.value = value),
    }),
    h("p", { class: "quiet small", role: "status" }, t(`people-role-${role}-about`)),
    h(Segments, {
      label: t("people-patients"),
      options: SHOWN.map((value) => ({ value, label: t(`people-patients-${value}`) })),
      chosen: shown.value,
      hidden: !isReviewer,
      onChange: (/** @type {Shown} */ value) => (shown.value = value),
    }),
    h(
      "div",
      { class: "shown-patients", role: "group", "aria-label": t("people-patients-chosen"), hidden: !isRestricted },
      patients.map(({ id, code, pseudonym }) =>
        h(
          "label",
          { class: "switch", key: id },
          h("input", {
            type: "checkbox",
            name: "patient",
            value: id,
            defaultChecked: person?.patients?.includes(id),
          }),
          h("span", {}, `${code} · ${pseudonym}`),
        ),
      ),
      !patients.length && h("p", { class: "quiet" }, t("people-patients-none")),
    ),
    h("p", { class: "problem", role: "alert" }, problem.value),
    h(
      "div",
      { class: "spread" },
      h(
        "button",
        { class: "btn go", "aria-disabled": isSending.value || undefined },
        t(person ? "people-rights-go" : "people-invite-go"),
      ),
      h("button", { type: "button", class: "btn", onClick: onClose }, t("cancel")),
    ),
  );
}
