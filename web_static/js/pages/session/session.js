/**
 * The record of a session: goal, notes, scales, what was driven, and the sign-off that locks it.
 * `#/session/ID`, `#/session/patient/PATIENT`, `#/session/compare/ID/ID`, `#/session/story/ID`.
 * @import { SessionRecordView } from "types/api"
 */
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { moment } from "../../widgets/format.js";
import { drivenCard } from "./driven_card.js";
import { goalCard } from "./goal_card.js";
import { notesCard } from "./notes_card.js";
import { scalesCard } from "./scales_card.js";
import { signOffCard } from "./sign_off_card.js";
import { unreadMarks } from "../../results/unread_marks.js";
import { originWords } from "../../results/origin_words.js";
import { reportCard } from "../../results/report_choice.js";

const OWN_PAGES = { patient: "patient_sessions", compare: "compare_sessions", story: "session_story" };

/**
 * What a card may do: whether it may change the record, and how; `change` shows the answer, or why it was refused.
 * @typedef {{
 *   mayChange: boolean, person: string, isOwner: boolean,
 *   change: (act: () => Promise<SessionRecordView>, words?: string) => Promise<boolean>,
 * }} Writing
 */

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal, rest }) {
  const own = OWN_PAGES[/** @type {keyof typeof OWN_PAGES} */ (rest[0])];
  if (own) return (await import(`./${own}.js`)).show(app, root, { signal, rest });
  const here = app.session?.session?.id;
  if (!rest[0] && !here) return app.go("#/patients");
  const id = Number(rest[0] || here);
  let record = await app.api.get(`/sessions/${id}`);
  const unread = await unreadMarks(app, record.patient_id, signal);
  if (signal.aborted) return;
  app.setSubject({ code: record.code, sessions: [record.number] });
  const place = h("div", { class: "body session-record" });
  const isDrafted = () =>
    [...place.querySelectorAll("textarea, input")].some((one) => isChanged(/** @type {HTMLInputElement} */ (one)));
  /** @type {Writing["change"]} */
  const change = async (act, words) => {
    try {
      record = await act();
    } catch (error) {
      if (!signal.aborted) app.toasts.show(failureWords(error));
      return false;
    }
    if (words && !signal.aborted) app.toasts.show(words);
    return true;
  };
  const draw = () => {
    const canWrite = app.me?.role === "owner" || app.me?.role === "clinician";
    /** @type {Writing} */
    const writing = {
      mayChange: canWrite && !record.sign_off,
      person: app.me?.name ?? "",
      isOwner: app.me?.role === "owner",
      change: async (act, words) => {
        const before = record.sign_off;
        const isDone = await change(act, words);
        // A sign-off changes every card; any other change is shown by its own card, so that drafts elsewhere stay.
        if (isDone && !signal.aborted && Boolean(before) !== Boolean(record.sign_off)) {
          draw();
          place.querySelector("h1")?.focus();
        }
        return isDone;
      },
    };
    const now = () => record;
    put(
      place,
      h("h1", { tabindex: "-1" }, t("record-title", { number: record.number, code: record.code })),
      h("p", { class: "lead" }, stateTag(record), " ", leadWords(record)),
      record.origin && h("p", { class: "quiet" }, originWords(record.origin)),
      !canWrite && h("p", { class: "quiet" }, t("record-only-read")),
      goalCard(app, now, writing),
      notesCard(app, now, writing),
      scalesCard(app, now, writing),
      drivenCard(record, unread),
      signOffCard(app, record, { ...writing, mayChange: canWrite }),
      reportCard(app, { id: record.patient_id, code: record.code, sessions: record.number }, record.number),
    );
  };
  /** @param {CustomEvent<string>} event */
  const read = async ({ detail }) => {
    if (
      !["record", "trial", "session", "everything"].includes(detail) ||
      isDrafted() ||
      place.contains(document.activeElement)
    )
      return;
    const found = await app.api.get(`/sessions/${id}`).catch(() => record);
    if (signal.aborted || isDrafted() || JSON.stringify(found) === JSON.stringify(record)) return;
    record = found;
    draw();
  };
  draw();
  app.live.addEventListener("changed", read, { signal });
  const back = h("a", { class: "btn", href: `#/session/patient/${record.patient_id}` }, t("record-back"));
  const story = h("a", { class: "btn", href: `#/session/story/${id}` }, t("record-story"));
  put(root, place, h("div", { class: "foot" }, h("span", { class: "grow" }), story, back));
}

/** @param {HTMLInputElement} input */
function isChanged(input) {
  return input.type !== "checkbox" && input.value !== input.defaultValue;
}

/** How a session stands, as a tag. @param {{ended: string | null, sign_off: unknown}} session */
export function stateTag({ ended, sign_off: signed }) {
  const state = signed ? "signed" : ended ? "ended" : "open";
  return h("span", { class: `tag${state === "signed" ? "" : " calm"}` }, t(`record-state-${state}`));
}

/** @param {SessionRecordView} record */
function leadWords({ started, opened_by: person, version }) {
  const began = t(person ? "record-began-by" : "record-began", { moment: moment(started), person });
  return `${began} · ${version ? t("record-version", { version }) : t("record-version-none")}`;
}
