/**
 * The notes of a session: each with who wrote it and when, its earlier texts, and a form for another text.
 * @import { NoteView, SessionRecordView } from "types/api"
 */
import { limitsOf } from "../../reference.js";
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { moment } from "../../widgets/format.js";
import { textForm } from "../../widgets/fields.js";

/** @param {import("../../main.js").App} app @param {() => SessionRecordView} now @param {import("./session.js").Writing} writing */
export function notesCard(app, now, { mayChange, change }) {
  const list = h("div", { class: "stack notes-of-session" });
  const { id } = now();
  const draw = () => {
    const { notes } = now();
    put(list, notes.length ? notes.map(row) : h("p", { class: "quiet" }, t("record-notes-none")));
  };
  /** @param {NoteView} note */
  const row = (note) => {
    const [newest, ...earlier] = note.revisions;
    const by = t(earlier.length ? "record-note-revised" : "record-note-by", {
      person: newest.person,
      moment: moment(newest.written),
    });
    const element = h("article", { class: "note-of-session" });
    const label = t("record-note-revise-label", { person: newest.person, moment: moment(newest.written) });
    const revise = () => {
      const send = async (/** @type {string} */ text) => {
        if (!(await change(() => app.api.put(`/sessions/${id}/notes/${note.id}`, { text })))) return;
        draw();
        /** @type {HTMLElement} */ (list.children[now().notes.findIndex((one) => one.id === note.id)])
          .querySelector("button")
          ?.focus();
      };
      const action = t("record-note-save");
      put(
        element,
        textForm({
          label: t("record-note-text"),
          text: newest.text,
          action,
          longest: limitsOf("NoteText", "text").longest ?? Infinity,
          send,
          onClose: draw,
        }),
      );
      element.querySelector("textarea")?.focus();
    };
    return put(
      element,
      h("p", { class: "own-words" }, newest.text),
      h(
        "div",
        { class: "spread" },
        h("span", { class: "quiet small grow" }, by),
        mayChange &&
          h(
            "button",
            { type: "button", class: "btn small", "aria-label": label, onclick: revise },
            t("record-note-revise"),
          ),
      ),
      earlier.length > 0 &&
        h(
          "details",
          {},
          h("summary", {}, t("record-note-history", { count: earlier.length })),
          earlier.map(({ text, person, written }) =>
            h(
              "div",
              { class: "earlier-text" },
              h("p", { class: "own-words" }, text),
              h("p", { class: "quiet small" }, t("record-note-by", { person, moment: moment(written) })),
            ),
          ),
        ),
    );
  };
  const place = h("div", {});
  const newForm = () => {
    const send = async (/** @type {string} */ text) => {
      if (!(await change(() => app.api.post(`/sessions/${id}/notes`, { text })))) return;
      draw();
      newForm();
      place.querySelector("textarea")?.focus();
    };
    put(
      place,
      textForm({
        label: t("record-note-new"),
        action: t("record-note-add"),
        longest: limitsOf("NoteText", "text").longest ?? Infinity,
        send,
      }),
    );
  };
  draw();
  if (mayChange) newForm();
  return h("section", { class: "card stack" }, h("h2", {}, t("record-notes")), list, place);
}
