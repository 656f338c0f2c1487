/**
 * The notes of a session: each with who wrote it and when, its earlier texts, and a form for another text.
 * @import { NoteView } from "types/api"
 * @import { RecordStore } from "./store.js"
 */
import { h, useOpenForm } from "../../preact.js";
import { limitsOf } from "../../reference.js";
import { EarlierTexts, TextForm } from "../../results/written_texts.js";
import { t } from "../../texts.js";
import { moment } from "../../widgets/format.js";

/** @param {{store: RecordStore}} card */
export function NotesCard({ store }) {
  const { app, record, mayChange, change } = store;
  const { id, notes } = record.value;
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("record-notes")),
    h(
      "div",
      { class: "stack notes-of-session" },
      notes.map((note) => h(Note, { key: note.id, note, store })),
      !notes.length && h("p", { class: "quiet" }, t("record-notes-none")),
    ),
    h(TextForm, {
      label: t("record-note-new"),
      longest: limitsOf("NoteText", "text").longest,
      action: t("record-note-add"),
      isOffered: mayChange.value,
      send: (text) => change(() => app.api.post(`/sessions/${id}/notes`, { text })),
    }),
  );
}

/** @param {{note: NoteView, store: RecordStore}} row */
function Note({ note: { id, revisions }, store: { app, record, mayChange, change } }) {
  const { isOpen, open, close, buttonRef } = useOpenForm();
  const [newest, ...earlier] = revisions;
  const when = { person: newest.person, moment: moment(newest.written) };
  if (isOpen) {
    const form = {
      label: t("record-note-text"),
      text: newest.text,
      longest: limitsOf("NoteText", "text").longest,
      action: t("record-note-save"),
      /** @param {string} text */
      send: (text) => change(() => app.api.put(`/sessions/${record.value.id}/notes/${id}`, { text })),
      onClose: close,
    };
    return h("article", { class: "note-of-session" }, h(TextForm, form));
  }
  const button = {
    type: /** @type {const} */ ("button"),
    class: "btn small",
    "aria-label": t("record-note-revise-label", when),
    ref: buttonRef,
    onClick: open,
  };
  return h(
    "article",
    { class: "note-of-session" },
    h("p", { class: "own-words" }, newest.text),
    h(
      "div",
      { class: "spread" },
      h("span", { class: "quiet small grow" }, t(earlier.length ? "record-note-revised" : "record-note-by", when)),
      mayChange.value && h("button", button, t("record-note-revise")),
    ),
    h(EarlierTexts, {
      title: t("record-note-history", { count: earlier.length }),
      earlier: earlier.map(({ text, person, written }) => ({
        text,
        written,
        byline: t("record-note-by", { person, moment: moment(written) }),
      })),
    }),
  );
}
