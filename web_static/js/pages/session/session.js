/**
 * The record of a session: goal, notes, scales, what was driven, and the sign-off that locks it.
 * `#/session/ID`, `#/session/patient/PATIENT`, `#/session/compare/ID/ID`, `#/session/story/ID`.
 * @import { CommentView, SessionRecordView } from "types/api"
 * @import { ReadonlySignal } from "../../preact.js"
 */
import { Fragment, h } from "../../preact.js";
import { t } from "../../texts.js";
import { moment } from "../../widgets/format.js";
import { DrivenCard } from "./driven_card.js";
import { drawWithLinks, StateTag } from "./frame.js";
import { GoalCard } from "./goal_card.js";
import { NotesCard } from "./notes_card.js";
import { ScalesCard } from "./scales_card.js";
import { SignOffCard } from "./sign_off_card.js";
import { mayWrite, recordStore } from "./store.js";
import { originWords } from "../../results/origin_words.js";
import { mayExport, ReportChoice } from "../../results/report_choice.js";
import { unreadComments } from "../../results/unread_marks.js";

const OWN_PAGES = { patient: "patient_sessions", compare: "compare_sessions", story: "session_story" };

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal: left, rest }) {
  const own = OWN_PAGES[/** @type {keyof typeof OWN_PAGES} */ (rest[0])];
  if (own) return (await import(`./${own}.js`)).show(app, root, { signal: left, rest });
  const here = app.session?.session?.id;
  if (!rest[0] && !here) return app.go("#/patients");
  const id = Number(rest[0] || here);
  const first = await app.api.get(`/sessions/${id}`);
  const { patient_id: patient, code, number } = first;
  const store = recordStore(app, first, left);
  const unread = await unreadComments(app, patient, left);
  if (left.aborted) return;
  app.setSubject({ patient, code, sessions: [number] });
  drawWithLinks(root, h(Page, { store, unread }), {
    [`#/session/story/${id}`]: t("record-story"),
    [`#/session/patient/${patient}`]: t("record-back"),
  });
}

/** @param {{store: import("./store.js").RecordStore, unread: ReadonlySignal<CommentView[]>}} page */
function Page({ store, unread }) {
  const { app, heading } = store;
  const record = store.record.value;
  const { patient_id: patient, code, number, origin } = record;
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1, ref: heading }, t("record-title", { number, code })),
    h("p", { class: "lead" }, h(StateTag, { session: record }), " ", leadWords(record)),
    origin && h("p", { class: "quiet" }, originWords(origin)),
    !mayWrite(app) && h("p", { class: "quiet" }, t("record-only-read")),
    h(GoalCard, { store }),
    h(NotesCard, { store }),
    h(ScalesCard, { store }),
    h(DrivenCard, { record, unread }),
    h(SignOffCard, { store }),
    mayExport(app) &&
      h(
        "section",
        { class: "card" },
        h("h2", {}, t("report-title")),
        h(ReportChoice, { app, patient: { id: patient, code, sessions: number }, session: number }),
      ),
  );
}

/** @param {SessionRecordView} record */
function leadWords({ started, opened_by: person, version }) {
  const began = t(person ? "record-began-by" : "record-began", { moment: moment(started), person });
  return `${began} · ${version ? t("record-version", { version }) : t("record-version-none")}`;
}
