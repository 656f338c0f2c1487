/**
 * The sessions of a patient, of which two can be compared, the consents, and what leaves the clinic: share links, exports.
 * @import { ConsentsView, SessionRow } from "types/api"
 */
import { t } from "../../texts.js";
import { h, put, set, write } from "../../widgets/dom.js";
import { moment } from "../../widgets/format.js";
import { rowList } from "../../widgets/list.js";
import { consentsCard } from "./consents_card.js";
import { exportCard } from "./export_card.js";
import { stateTag } from "./session.js";
import { mayExport } from "../../results/report_choice.js";
import { originWords } from "../../results/origin_words.js";
import { unreadMarks } from "../../results/unread_marks.js";
import { shareCard } from "./share_card.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal, rest: [, patient, part] }) {
  const id = Number(patient);
  const [sessions, consents, shares, unread] = await Promise.all([
    app.api.get(`/patients/${id}/sessions`),
    app.api.get(`/patients/${id}/consents`),
    mayExport(app) ? app.api.get(`/patients/${id}/shares`) : null,
    unreadMarks(app, id, signal),
  ]);
  if (signal.aborted) return;
  const choice = sessionChoice();
  const leaves = h("div", { class: "leaves" });
  const sharing = shares && sessions.length > 0 ? shareCard(app, consents, sessions, shares, signal) : null;
  /** @param {ConsentsView} now */
  const offer = (now) => {
    put(leaves, exportCard(app, now, sessions));
    sharing?.setConsents(now);
  };
  offer(consents);
  const list = rowList("people");
  list.show(
    sessions.map((session) => row(session, choice.box(session), unread({ session_id: session.id }))),
    h("p", { class: "card quiet" }, t("record-sessions-none")),
  );
  put(
    root,
    h(
      "div",
      { class: "body session-record" },
      h("h1", { tabindex: "-1" }, t("record-sessions", { code: consents.code })),
      h("p", { class: "lead" }, t("record-sessions-lead")),
      consentsCard(app, consents, offer),
      list,
      sessions.length > 1 && choice.element,
      sharing?.element,
      leaves,
    ),
    h(
      "div",
      { class: "foot" },
      h("span", { class: "grow" }),
      h("a", { class: "btn", href: `#/review/${id}` }, t("rail-review")),
    ),
  );
  if (part === "compare") list.scrollIntoView(); // the consents stand above
}

/** @param {SessionRow} session @param {HTMLElement} box @param {HTMLElement} unread its mark */
function row(session, box, unread) {
  const { id, number, started, trials, sign_off: signed, origin } = session;
  return h(
    "div",
    { class: "card person" },
    box,
    h(
      "div",
      { class: "grow" },
      h("a", { class: "row-link", href: `#/session/${id}` }, t("verdict-session", { number })),
      " ",
      stateTag(session),
      " ",
      unread,
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

/** A box for each session, and the link that compares the two that are ticked; a third takes the place of the first. */
function sessionChoice() {
  /** @type {{id: number, input: HTMLInputElement}[]} */
  let chosen = [];
  const link = h("a", { class: "btn", "aria-disabled": "true" }, t("record-compare"));
  const words = h("span", { class: "quiet", role: "status" }, t("record-compare-choose", { count: 2 }));
  const draw = () => {
    const isReady = chosen.length === 2;
    set(link, {
      href: isReady
        ? `#/session/compare/${chosen
            .map((one) => one.id)
            .sort((a, b) => a - b)
            .join("/")}`
        : null,
      "aria-disabled": isReady ? null : "true",
    });
    write(words, isReady ? "" : t("record-compare-choose", { count: 2 - chosen.length }));
  };
  /** @param {SessionRow} session */
  const box = ({ id, number }) => {
    const input = h("input", { type: "checkbox", "aria-label": t("record-compare-pick", { number }) });
    input.addEventListener("change", () => {
      chosen = chosen.filter((one) => one.id !== id);
      if (input.checked) chosen.push({ id, input });
      if (chosen.length > 2) {
        chosen[0].input.checked = false;
        chosen = chosen.slice(1);
      }
      draw();
    });
    return h("label", { class: "pick" }, input);
  };
  return { element: h("div", { class: "spread compare-choice" }, link, words), box };
}
