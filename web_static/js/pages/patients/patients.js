/**
 * Patients: list, search, new, delete with undo, and whose session this is.
 * @import { App } from "../../main.js"
 * @import { PatientView } from "types/api"
 */
import { ApiError } from "../../api.js";
import { passFocus } from "../../focus.js";
import { archiveImport } from "./archive_import.js";
import { DeletionForm } from "./deletion_form.js";
import { onNews } from "../../live/news.js";
import { drawPage, Fragment, h, signal, useOpening, useSignal } from "../../preact.js";
import { day, minuteOfDay } from "../../widgets/format.js";
import { Icon } from "../../widgets/icons.js";
import { NewPatientForm } from "./patient_form.js";
import { ask } from "../../widgets/question.js";
import { mayExport, ReportChoice } from "../../results/report_choice.js";
import { t } from "../../texts.js";

const CONFLICT = 409;
const SECOND_TAP = 1000; // ms: so late may a hasty second tap on a button come

/** @param {App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal: left }) {
  const isOwner = app.me?.role === "owner";
  const [first, people] = await Promise.all([
    app.api.get("/patients"),
    isOwner && !app.me?.demo ? app.api.get("/people") : null,
  ]);
  if (left.aborted) return;
  const patients = signal(first);
  const here = signal(app.session?.patient?.id ?? null); // id of the patient who is here
  const searched = signal("");
  // The form above the list: for a new patient, or for the reason of a deletion.
  const opened = signal(/** @type {{deleted?: PatientView, message?: string} | null} */ (null));
  let changedAt = -Infinity; // ms, when the list showed somebody else as here

  const read = async () => void (patients.value = await app.api.get("/patients"));
  const close = () => void (opened.value = null);
  // In a shirt that nobody wears there is nothing to look at before the calibration.
  const unknown = () => (app.practice ? "#/calibrate" : "#/shirt");
  const goOn = () => app.go(app.session?.has_profile ? "#/drive" : unknown());
  let turn = Promise.resolve();
  /** One after the other: a change names the session that the one before it left. @param {() => Promise<void>} change */
  const inTurn = (change) => (turn = turn.then(change, change));
  /** @param {PatientView} patient */
  const open = (patient) =>
    inTurn(async () => {
      const begun = await app.toasts.attempt(async () => {
        const ends = await agreedEnd(app, patient);
        return ends === undefined ? null : app.api.post("/session", { patient_id: patient.id, ends });
      });
      if (!begun) return read();
      await app.readSession({ isOwn: true });
      goOn();
    });
  /** @param {PatientView} patient */
  const remove = async (patient) => {
    if (performance.now() - changedAt < SECOND_TAP) return; // the bin took the place of "End session" under the finger
    try {
      await app.api.remove(`/patients/${patient.id}`);
    } catch (error) {
      if (!(error instanceof ApiError && error.status === CONFLICT))
        return void app.toasts.attempt(() => Promise.reject(error));
      opened.value = { deleted: patient, message: error.message };
      return;
    }
    await removed(patient);
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
      app.toasts.show(t("patients-ended"));
    });
  const actions = { open, remove, end, goOn };

  const Opened = () => {
    const place = useOpening(opened.value);
    return h("div", { ref: place, hidden: !opened.value }, opened.value && opening(opened.value));
  };
  /** @param {NonNullable<typeof opened.value>} now */
  const opening = ({ deleted, message = "" }) => {
    if (!deleted) return h(NewPatientForm, { app, onAdded: open, onClose: close });
    /** @param {string} reason */
    const send = async (reason) => {
      await app.api.remove(`/patients/${deleted.id}`, { reason });
      close();
      await removed(deleted);
    };
    return h(DeletionForm, { key: deleted.id, message, send, onClose: close });
  };
  const List = () => {
    const words = searched.value.trim();
    const found = patients.value.filter(({ code, pseudonym }) =>
      `${code} ${pseudonym}`.toLowerCase().includes(words.toLowerCase()),
    );
    const none = words ? t("patients-none-found", { words }) : t("patients-empty");
    return h(
      "div",
      { class: "people", role: found.length ? "list" : undefined },
      found.map((patient) => h(Row, { key: patient.id, app, patient, here: here.value, actions })),
      !found.length && h("p", { class: "card quiet" }, none),
    );
  };
  const newButton = () =>
    h(
      "button",
      { type: "button", class: "btn", onClick: () => (opened.value = {}) },
      h(Icon, { name: "plus", size: 20 }),
      t("patients-new"),
    );
  const archive = isOwner ? archiveImport(app, read, left) : null;
  const search = t("patients-search");

  app.addEventListener(
    "session",
    () => {
      const now = app.session?.patient?.id ?? null;
      if (now !== here.value) changedAt = performance.now();
      here.value = now;
    },
    { signal: left },
  );
  /** @type {import("../../live/news.js").Interest} */
  const interest = { what: ["session", "trial", "deletion", "restoration"] };
  onNews(app, left, interest, () => read().catch(() => null));
  drawPage(
    root,
    h(
      Fragment,
      {},
      h("h1", { tabindex: -1 }, t("patients-title")),
      h("p", { class: "lead" }, t("patients-lead")),
      h(
        "div",
        { class: "spread above-list" },
        h(
          "div",
          { class: "grow" },
          h("input", {
            type: "search",
            "aria-label": search,
            placeholder: search,
            onInput: ({ currentTarget }) => (searched.value = currentTarget.value),
          }),
        ),
        mayChange(app) && newButton(),
        archive && h(archive.ImportButton, {}),
      ),
      archive && h(archive.ImportCourse, {}),
      h(Opened, {}),
      h(List, {}),
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

/** The patient's report, made when it is opened: a list has many patients. @param {{app: App, patient: PatientView}} report */
function Report({ app, patient }) {
  const wasOpened = useSignal(false);
  return h(
    "details",
    { class: "report", onToggle: () => (wasOpened.value = true) },
    h("summary", {}, t("report-title")),
    h("div", {}, wasOpened.value && h(ReportChoice, { app, patient })),
  );
}

/**
 * @param {object} row
 * @param {App} row.app @param {PatientView} row.patient @param {number | null} row.here id of the patient who is here
 * @param {{open: (patient: PatientView) => Promise<void>, remove: (patient: PatientView) => void, end: () => void,
 *   goOn: () => void}} row.actions
 */
function Row({ app, patient, here, actions: { open, remove, end, goOn } }) {
  const isOpening = useSignal(false); // opening a session takes a moment: a second tap shall do nothing
  const { id, code, pseudonym, note } = patient;
  const isHere = here === id;
  const figures = [
    t("patients-sessions", { count: patient.sessions }),
    t("patients-trials", { count: patient.trials }),
    patient.last_seen ? t("patients-last", { day: day(patient.last_seen) }) : t("patients-never"),
  ].join(" · ");
  const start = async () => {
    if (isOpening.value) return;
    isOpening.value = true;
    await open(patient).finally(() => (isOpening.value = false));
  };
  // Keys: no button becomes another one under a finger, or with the focus on it.
  const changes = () =>
    isHere
      ? [
          h("button", { key: "end", type: "button", class: "btn", ref: passFocus, onClick: end }, t("patients-end")),
          h("button", { key: "go", type: "button", class: "btn go", onClick: goOn }, t("patients-go-on")),
        ]
      : [
          h(
            "button",
            {
              key: "delete",
              type: "button",
              class: "icon-button",
              "aria-label": t("patients-delete", { code }),
              ref: passFocus,
              onClick: () => remove(patient),
            },
            h(Icon, { name: "bin", size: 22 }),
          ),
          h(
            "button",
            {
              key: "start",
              type: "button",
              class: `btn${here === null ? " go" : ""}`,
              "aria-disabled": isOpening.value || undefined,
              onClick: start,
            },
            t("patients-start"),
          ),
        ];
  return h(
    "div",
    { class: `person card${isHere ? " here" : ""}`, role: "listitem" },
    h("span", { class: "badge", "aria-hidden": "true" }, pseudonym.slice(0, 1).toUpperCase()),
    h(
      "div",
      { class: "grow" },
      h("b", {}, code),
      ` ${pseudonym} `,
      isHere && h("span", { class: "tag" }, t("patients-here")),
      h("div", { class: "quiet small" }, figures, note && ` · ${note}`),
      h(
        "a",
        { class: "row-link", href: `#/session/patient/${id}`, "aria-label": t("record-link-label", { code }) },
        t("record-link"),
      ),
      mayExport(app) && patient.sessions > 0 && h(Report, { app, patient }),
    ),
    mayChange(app) ? changes() : h("a", { class: "btn go", href: `#/review/${id}` }, t("rail-review")),
  );
}
