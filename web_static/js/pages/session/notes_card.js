/**
 * The notes of a session: each with who wrote it and when, its earlier texts, and a form for another text.
 * @import { NoteView } from "types/api"
 * @import { RecordStore } from "./store.js"
 */
import { focusFirst, h, useLayoutEffect, useRef, useSignal } from "../../preact.js";
import { limitsOf } from "../../reference.js";
import { t } from "../../texts.js";
import { Field } from "../../widgets/fields.js";
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
    h(NoteForm, {
      label: t("record-note-new"),
      action: t("record-note-add"),
      isOffered: mayChange.value,
      send: (text) => change(() => app.api.post(`/sessions/${id}/notes`, { text })),
    }),
  );
}

/** @param {{note: NoteView, store: RecordStore}} row */
function Note({ note: { id, revisions }, store: { app, record, mayChange, change } }) {
  const isRevised = useSignal(false);
  const wasRevised = useRef(false);
  const [newest, ...earlier] = revisions;
  const when = { person: newest.person, moment: moment(newest.written) };
  const revise = () => (isRevised.value = wasRevised.current = true);
  const close = () => void (isRevised.value = false);
  /** @param {string} text */
  const send = async (text) => {
    const isDone = await change(() => app.api.put(`/sessions/${record.value.id}/notes/${id}`, { text }));
    if (isDone) close();
    return isDone;
  };
  if (isRevised.value) {
    const [label, action] = [t("record-note-text"), t("record-note-save")];
    const form = h(NoteForm, { label, text: newest.text, action, isOffered: true, send, onClose: close });
    return h("article", { class: "note-of-session" }, form);
  }
  const button = {
    type: /** @type {const} */ ("button"),
    class: "btn small",
    "aria-label": t("record-note-revise-label", when),
    ref: wasRevised.current ? focusFirst : null, // it has the focus again when the form closes
    onClick: revise,
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
    earlier.length > 0 &&
      h(
        "details",
        {},
        h("summary", {}, t("record-note-history", { count: earlier.length })),
        earlier.map(({ text, person, written }) =>
          h(
            "div",
            { class: "earlier-text", key: written },
            h("p", { class: "own-words" }, text),
            h("p", { class: "quiet small" }, t("record-note-by", { person, moment: moment(written) })),
          ),
        ),
      ),
  );
}

/**
 * @param {object} form
 * @param {string} form.label @param {string} [form.text] before
 * @param {string} form.action words of the button that sends
 * @param {boolean} form.isOffered otherwise the form stays only as long as something is typed in it
 * @param {(text: string) => Promise<boolean>} form.send called with a text that is not empty
 * @param {() => void} [form.onClose] of a form that was opened; without it the form stays
 */
function NoteForm({ label, text = "", action, isOffered, send, onClose }) {
  const draft = useSignal(text);
  const input = useRef(/** @type {HTMLTextAreaElement | null} */ (null));
  useLayoutEffect(() => {
    if (onClose) input.current?.focus();
  }, []);
  if (!isOffered && !draft.value) return null;
  /** @param {{currentTarget: HTMLTextAreaElement}} event */
  const type = ({ currentTarget }) => (draft.value = currentTarget.value);
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    const written = draft.value.trim();
    if (!written || !(await send(written)) || onClose) return;
    draft.value = "";
    input.current?.focus();
  };
  const { longest } = limitsOf("NoteText", "text");
  return h(
    "form",
    { class: "stack", onSubmit: submit },
    h(
      Field,
      { label },
      h("textarea", { rows: 3, maxlength: longest, required: true, ref: input, value: draft.value, onInput: type }),
    ),
    h(
      "div",
      { class: "spread" },
      h("button", { class: "btn" }, action),
      onClose && h("button", { type: "button", class: "btn", onClick: onClose }, t("cancel")),
    ),
  );
}
