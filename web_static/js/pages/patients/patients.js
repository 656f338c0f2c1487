/**
 * Patients: list, search, new, delete with undo, and whose session this is.
 * @import { App } from "../../main.js"
 * @import { PatientView } from "types/api"
 */
import { ApiError } from "../../api.js";
import { archiveImport } from "./archive_import.js";
import { deletionForm } from "./deletion_form.js";
import { h, put } from "../../widgets/dom.js";
import { day, minuteOfDay } from "../../widgets/format.js";
import { icon } from "../../widgets/icons.js";
import { rowList } from "../../widgets/list.js";
import { newPatientForm } from "./patient_form.js";
import { ask } from "../../widgets/question.js";
import { mayExport, reportChoice } from "../../results/report_choice.js";
import { t } from "../../texts.js";

const CONFLICT = 409;
const SECOND_TAP = 1000; // ms: so late may a hasty second tap on a button come
const NEWS = new Set(["session", "trial", "everything"]); // after which a row may differ

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal }) {
  const isOwner = app.me?.role === "owner";
  const [first, people] = await Promise.all([
    app.api.get("/patients"),
    isOwner && !app.me?.demo ? app.api.get("/people") : null,
  ]);
  let patients = first;
  if (signal.aborted) return;
  const list = rowList("people");
  const search = h("input", { type: "search", "aria-label": t("patients-search"), placeholder: t("patients-search") });
  const form = h("div", { hidden: true });

  const read = async () => {
    patients = await app.api.get("/patients");
    showList();
  };
  /** @param {CustomEvent<string>} event */
  const follow = async ({ detail }) => {
    if (!NEWS.has(detail)) return;
    const now = await app.api.get("/patients").catch(() => patients);
    if (signal.aborted || JSON.stringify(now) === JSON.stringify(patients)) return; // an open report stays open
    patients = now;
    showList();
  };
  // In a shirt that nobody wears there is nothing to look at before the calibration.
  const unknown = () => (app.practice ? "#/calibrate" : "#/shirt");
  const goOn = () => app.go(app.session?.has_profile ? "#/drive" : unknown());
  let turn = Promise.resolve();
  /** One after the other: a change names the session that the one before it left. @param {() => Promise<void>} change */
  const inTurn = (change) => (turn = turn.then(change, change));
  /** @param {PatientView} patient @param {HTMLButtonElement | null} [button] that was tapped */
  const open = (patient, button = null) => {
    if (button) button.disabled = true; // opening a session takes a moment: a second tap shall do nothing
    return inTurn(async () => {
      const begun = await app.toasts.attempt(async () => {
        const ends = await agreedEnd(app, patient);
        return ends === undefined ? null : app.api.post("/session", { patient_id: patient.id, ends });
      });
      if (!begun) return read();
      await app.readSession({ isOwn: true });
      goOn();
    });
  };
  let shownHere = app.session?.patient?.id; // the patient who is here, in the list as it is shown
  let changedAt = -Infinity; // ms, when the list showed somebody else as here
  /** @param {PatientView} patient */
  const remove = async (patient) => {
    if (performance.now() - changedAt < SECOND_TAP) return; // the bin took the place of "End session" under the finger
    try {
      await app.api.remove(`/patients/${patient.id}`);
    } catch (error) {
      if (error instanceof ApiError && error.status === CONFLICT) return askWhy(patient, error.message);
      return void app.toasts.attempt(() => Promise.reject(error));
    }
    await removed(patient);
  };
  /** @param {PatientView} patient @param {string} words */
  const askWhy = (patient, words) => {
    /** @param {string} reason */
    const send = async (reason) => {
      await app.api.remove(`/patients/${patient.id}`, { reason });
      form.hidden = true;
      await removed(patient);
    };
    form.hidden = false;
    put(form, deletionForm(words, { send, onClose: () => (form.hidden = true) }));
    form.querySelector("input")?.focus();
  };
  /** @param {PatientView} patient */
  const removed = async (patient) => {
    await Promise.all([read(), app.readSession({ isOwn: true })]);
    const restore = async () => {
      await app.toasts.attempt(() => app.api.post(`/patients/${patient.id}/restore`));
      await read();
    };
    app.toasts.show(t("patients-deleted", { code: patient.code }), { action: t("undo"), run: restore });
  };
  const end = () =>
    inTurn(async () => {
      if (!(await app.toasts.attempt(() => app.api.remove("/session")))) return;
      await app.readSession({ isOwn: true });
      showList();
      app.toasts.show(t("patients-ended"));
    });
  const showList = () => {
    const here = app.session?.patient?.id;
    if (here !== shownHere) [shownHere, changedAt] = [here, performance.now()];
    const words = search.value.trim().toLowerCase();
    const found = patients.filter((patient) => `${patient.code} ${patient.pseudonym}`.toLowerCase().includes(words));
    const none = words ? t("patients-none-found", { words: search.value.trim() }) : t("patients-empty");
    list.show(
      found.map((patient) => row(app, patient, { open, remove, end, goOn })),
      h("p", { class: "card quiet" }, none),
    );
  };
  const showForm = () => {
    form.hidden = false;
    put(form, newPatientForm(app, { onAdded: (patient) => open(patient), onClose: () => (form.hidden = true) }));
    form.querySelector("input")?.focus();
  };
  const archive = isOwner ? archiveImport(app, read, signal) : null;
  search.addEventListener("input", showList);
  app.addEventListener("session", () => app.session?.patient?.id !== shownHere && showList(), { signal });
  app.live.addEventListener("changed", follow, { signal });
  showList();
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("patients-title")),
      h("p", { class: "lead" }, t("patients-lead")),
      h(
        "div",
        { class: "spread above-list" },
        h("div", { class: "grow" }, search),
        mayChange(app) &&
          h("button", { type: "button", class: "btn", onclick: showForm }, icon("plus", 20), t("patients-new")),
        archive?.button,
      ),
      archive?.course,
      form,
      list,
      people?.length === 1 && invitation(),
    ),
  );
}

/** For an owner whom nobody helps yet. */
function invitation() {
  return h(
    "p",
    { class: "after-list spread" },
    h("span", { class: "quiet" }, t("patients-alone")),
    h("a", { class: "btn small", href: "#/people/invite" }, t("people-invite")),
  );
}

/**
 * Ask before another patient's open session is ended: whose it is, who opened it, since when, how many trials it has.
 * @param {App} app @param {PatientView} patient who comes next
 * @returns {Promise<number | null | undefined>} id of the session to end; null: none is open; undefined: the person cancelled
 */
async function agreedEnd(app, patient) {
  const { patient: other, session } = await app.api.get("/session");
  if (!other || !session || other.id === patient.id) return null;
  const question = t(session.opened_by ? "patients-ends" : "patients-ends-somebody", {
    code: other.code,
    name: session.opened_by ?? "",
    time: minuteOfDay(session.started),
    trials: session.trials,
  });
  const answer = await ask(app.question, question, [
    { value: "end", label: t("patients-ends-go", { next: patient.code }), kind: "btn go" },
    { value: null, label: t("cancel") },
  ]);
  return answer ? session.id : undefined;
}

/** A reviewer looks, and changes nothing. @param {App} app */
const mayChange = (app) => app.me?.role !== "reviewer";

/** The patient's report, made when it is opened: a list has many patients. @param {App} app @param {PatientView} patient */
function report(app, patient) {
  if (!mayExport(app) || !patient.sessions) return null;
  const place = h("div", {});
  const summary = h("summary", {}, t("report-title"));
  const details = h("details", { class: "report" }, summary, place);
  details.addEventListener("toggle", () => place.childElementCount || put(place, reportChoice(app, patient)));
  return details;
}

/**
 * @param {App} app @param {PatientView} patient
 * @param {{open: (patient: PatientView, button: HTMLButtonElement) => void, remove: (patient: PatientView) => void,
 *   end: () => void, goOn: () => void}} actions
 */
function row(app, patient, { open, remove, end, goOn }) {
  const isHere = app.session?.patient?.id === patient.id;
  const figures = [
    t("patients-sessions", { count: patient.sessions }),
    t("patients-trials", { count: patient.trials }),
    patient.last_seen ? t("patients-last", { day: day(patient.last_seen) }) : t("patients-never"),
  ].join(" · ");
  const changes = () =>
    isHere
      ? [
          h("button", { type: "button", class: "btn", onclick: end }, t("patients-end")),
          h("button", { type: "button", class: "btn go", onclick: goOn }, t("patients-go-on")),
        ]
      : [
          h(
            "button",
            {
              type: "button",
              class: "icon-button",
              "aria-label": t("patients-delete", { code: patient.code }),
              onclick: () => remove(patient),
            },
            icon("bin", 22),
          ),
          h(
            "button",
            {
              type: "button",
              class: `btn${app.session?.patient ? "" : " go"}`,
              onclick: ({ currentTarget }) => open(patient, /** @type {HTMLButtonElement} */ (currentTarget)),
            },
            t("patients-start"),
          ),
        ];
  return h(
    "div",
    { class: `person card${isHere ? " here" : ""}` },
    h("span", { class: "badge", "aria-hidden": "true" }, patient.pseudonym.slice(0, 1).toUpperCase()),
    h(
      "div",
      { class: "grow" },
      h("b", {}, patient.code),
      " ",
      patient.pseudonym,
      " ",
      isHere && h("span", { class: "tag" }, t("patients-here")),
      h("div", { class: "quiet small" }, figures, patient.note && ` · ${patient.note}`),
      h(
        "a",
        {
          class: "row-link",
          href: `#/session/patient/${patient.id}`,
          "aria-label": t("record-link-label", { code: patient.code }),
        },
        t("record-link"),
      ),
      report(app, patient),
    ),
    mayChange(app) ? changes() : h("a", { class: "btn go", href: `#/review/${patient.id}` }, t("rail-review")),
  );
}
