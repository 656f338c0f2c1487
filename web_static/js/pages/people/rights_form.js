/**
 * The form for a person's name and rights: role, and for a reviewer which patients.
 * @import { PatientView, PersonView } from "types/api"
 */
import { textLimits } from "../../reference.js";
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { field, segments } from "../../widgets/fields.js";

/** @typedef {PersonView["role"]} Role */
const ROLES = /** @type {const} */ (["clinician", "reviewer", "owner"]);

/**
 * @param {PatientView[]} patients
 * @param {PersonView | null} person whose rights are changed; null: somebody new
 * @param {{send: (rights: {name: string, role: Role, patients: number[] | null}) => Promise<void>, onClose: () => void}} then
 */
export function rightsForm(patients, person, { send, onClose }) {
  const name = h("input", { type: "text", required: true, ...textLimits("NewPerson", "name"), autocomplete: "off" });
  /** @type {Role} */
  let role = person?.role ?? "clinician";
  /** @type {"all" | "chosen"} */
  let shownAre = person?.patients ? "chosen" : "all";
  const boxes = patients.map(({ id, code, pseudonym }) => {
    const box = h("input", { type: "checkbox", value: id, checked: person?.patients?.includes(id) ?? false });
    return { id, box, row: h("label", { class: "switch" }, box, h("span", {}, `${code} · ${pseudonym}`)) };
  });
  const about = h("p", { class: "quiet small", role: "status" });
  const chosen = h(
    "div",
    { class: "shown-patients", role: "group", "aria-label": t("people-patients-chosen") },
    boxes.map(({ row }) => row),
    !boxes.length && h("p", { class: "quiet" }, t("people-patients-none")),
  );
  const which = segments(
    t("people-patients"),
    [
      { value: "all", label: t("people-patients-all") },
      { value: "chosen", label: t("people-patients-chosen") },
    ],
    shownAre,
    (value) => {
      shownAre = value;
      draw();
    },
  );
  const draw = () => {
    which.hidden = role !== "reviewer";
    chosen.hidden = role !== "reviewer" || shownAre === "all";
    about.textContent = t(`people-role-${role}-about`);
  };
  const roles = segments(
    t("people-role"),
    ROLES.map((value) => ({ value, label: t(`people-role-${value}`) })),
    role,
    (value) => {
      role = value;
      draw();
    },
  );
  const problem = h("p", { class: "problem", role: "alert" });
  const go = h("button", { class: "btn go" }, t(person ? "people-rights-go" : "people-invite-go"));
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    problem.textContent = "";
    go.disabled = true; // a second tap would invite twice
    const shown = boxes.filter(({ box }) => box.checked).map(({ id }) => id);
    const restricted = role === "reviewer" && shownAre === "chosen";
    await send({ name: name.value.trim(), role, patients: restricted ? shown : null }).catch(
      (error) => (problem.textContent = failureWords(error)),
    );
    go.disabled = false;
  };
  draw();
  return h(
    "form",
    { class: "card stack", onsubmit: submit },
    h("h2", {}, person ? t("people-rights-title", { name: person.name }) : t("people-invite")),
    !person && field(t("sign-in-name"), name, t("people-name-hint")),
    roles,
    about,
    which,
    chosen,
    problem,
    h("div", { class: "spread" }, go, h("button", { type: "button", class: "btn", onclick: onClose }, t("cancel"))),
  );
}
