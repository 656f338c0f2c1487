/**
 * The sessions of a patient, of which two can be compared, the consents, and what leaves the clinic: links, exports.
 * @import { CommentView, ConsentsView, SessionRow, SharesView } from "types/api"
 * @import { ReadonlySignal, Signal } from "../../preact.js"
 */
import { newestAnswer } from "../../live/newest_answer.js";
import { Fragment, h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { moment } from "../../widgets/format.js";
import { ConsentsCard } from "./consents_card.js";
import { ExportCard } from "./export_card.js";
import { drawWithLinks, StateTag } from "./frame.js";
import { mayExport } from "../../results/report_choice.js";
import { PairLink, withChoice } from "../../results/pair_choice.js";
import { originWords } from "../../results/origin_words.js";
import { UnreadCount, unreadComments } from "../../results/unread_marks.js";
import { ShareCard } from "./share_card.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal: left, rest: [, patient, part] }) {
  const id = Number(patient);
  const askShares = () => app.api.get(`/patients/${id}/shares`);
  const [sessions, consents, links, unread] = await Promise.all([
    app.api.get(`/patients/${id}/sessions`),
    app.api.get(`/patients/${id}/consents`),
    mayExport(app) ? askShares() : null,
    unreadComments(app, id, left),
  ]);
  if (left.aborted) return;
  app.setSubject({ patient: id, code: consents.code, sessions: [] });
  const shares = links && newestAnswer(app, left, links, askShares, { what: ["shares"], patient: id });
  drawWithLinks(root, h(Page, { app, left, sessions, first: consents, shares, unread }), {
    [`#/review/${id}`]: t("rail-review"),
  });
  if (part === "compare") root.querySelector(".people")?.scrollIntoView(); // the consents stand above
}

/**
 * @param {object} page
 * @param {import("../../main.js").App} page.app @param {AbortSignal} page.left @param {SessionRow[]} page.sessions
 * @param {ConsentsView} page.first the consents that were answered
 * @param {Signal<SharesView> | null} page.shares null without the right to share
 * @param {ReadonlySignal<CommentView[]>} page.unread
 */
function Page({ app, left, sessions, first, shares, unread }) {
  const consents = useSignal(first);
  const pair = useSignal(/** @type {SessionRow[]} */ ([])); // the sessions to compare, at most two
  const { patient_id: patient, code } = first;
  const isConsented = consents.value.consents.some(({ consent, given }) => consent === "sharing" && given);
  const shared = { app, left, patient, code, sessions, isConsented };
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, t("record-sessions", { code })),
    h("p", { class: "lead" }, t("record-sessions-lead")),
    h(ConsentsCard, { app, view: consents.value, onChange: (now) => (consents.value = now) }),
    h(
      "div",
      { class: "people", role: sessions.length ? "list" : undefined },
      sessions.map((session) =>
        h(Row, {
          key: session.id,
          session,
          isChosen: pair.value.some(({ id }) => id === session.id),
          onChoose: (isChosen) => (pair.value = withChoice(pair.value, session, isChosen)),
          unread,
        }),
      ),
      !sessions.length && h("p", { class: "card quiet" }, t("record-sessions-none")),
    ),
    sessions.length > 1 && h(Comparison, { pair: pair.value }),
    shares && sessions.length > 0 && h(ShareCard, { ...shared, shares }),
    h("div", { class: "leaves" }, mayExport(app) && sessions.length > 0 && h(ExportCard, shared)),
  );
}

/**
 * @param {object} row
 * @param {SessionRow} row.session @param {boolean} row.isChosen @param {(isChosen: boolean) => void} row.onChoose
 * @param {ReadonlySignal<CommentView[]>} row.unread
 */
function Row({ session, isChosen, onChoose, unread }) {
  const { id, number, started, trials, sign_off: signed, origin } = session;
  return h(
    "div",
    { class: "card person", role: "listitem" },
    h(
      "label",
      { class: "pick" },
      h("input", {
        type: "checkbox",
        "aria-label": t("record-compare-pick", { number }),
        checked: isChosen,
        onChange: ({ currentTarget }) => onChoose(currentTarget.checked),
      }),
    ),
    h(
      "div",
      { class: "grow" },
      h("a", { class: "row-link", href: `#/session/${id}` }, t("verdict-session", { number })),
      " ",
      h(StateTag, { session }),
      " ",
      h(UnreadCount, { comments: unread, about: { session_id: id } }),
      h("div", { class: "quiet small" }, `${moment(started)} · ${t("patients-trials", { count: trials })}`),
      origin && h("div", { class: "quiet small" }, originWords(origin)),
      signed &&
        h("div", { class: "quiet small" }, t("record-signed", { person: signed.person, moment: moment(signed.at) })),
    ),
    h(
      "a",
      { class: "btn", href: `#/session/story/${id}`, "aria-label": t("record-story-label", { number }) },
      t("record-story"),
    ),
  );
}

/** The link that compares two sessions, and how many are still to be ticked. @param {{pair: SessionRow[]}} comparison */
function Comparison({ pair }) {
  const missing = 2 - pair.length;
  const ids = pair.map(({ id }) => id).sort((a, b) => a - b);
  return h(PairLink, {
    words: t("record-compare"),
    href: missing ? undefined : `#/session/compare/${ids.join("/")}`,
    state: missing ? t("record-compare-choose", { count: missing }) : "",
  });
}
