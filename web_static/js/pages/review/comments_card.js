/**
 * The comments on moments of a trial, beside its replay: each leads to its moment, and its author can change it.
 * @import { App } from "../../main.js"
 * @import { CommentView } from "types/api"
 * @import { PlayHead } from "./play_head.js"
 * @typedef {ReturnType<typeof commentStore>} CommentStore
 */
import { newestAnswer } from "../../live/newest_answer.js";
import { createRef, h, useComputed, useOpenForm, useOpening, useRef } from "../../preact.js";
import { limitsOf } from "../../reference.js";
import { EarlierTexts, TextForm } from "../../results/written_texts.js";
import { t } from "../../texts.js";
import { moment, number } from "../../widgets/format.js";
import { go } from "./play_bar.js";

const NEAR = 0.05; // s from the moment that the replay shows

/**
 * @param {App} app @param {number} trial id @param {CommentView[]} first the comments on the trial as they were read
 * @param {AbortSignal} left
 */
export function commentStore(app, trial, first, left) {
  const ask = () => app.api.get(`/trials/${trial}/comments`);
  const comments = newestAnswer(app, left, first, ask, { what: ["comment"], trial });
  /** @type {Set<number>} the ids of those that were unread when this page first showed them */
  const fresh = new Set();
  comments.subscribe((now) => {
    const unread = now.filter((comment) => comment.unread);
    if (!unread.length || left.aborted) return;
    for (const { id } of unread) fresh.add(id);
    app.api.post(`/trials/${trial}/comments/read`).catch(() => {});
  });
  const heading = /** @type {{current: HTMLElement | null}} */ (createRef());
  /**
   * Change the comments, and return whether it was done; a refusal is shown.
   * @param {() => Promise<CommentView[]>} act @param {string} message shown when it was done
   */
  const change = async (act, message) => {
    const now = await app.toasts.attempt(act);
    if (!now || left.aborted) return false;
    comments.value = now;
    app.toasts.show(message);
    return true;
  };
  return { app, trial, comments, fresh, heading, change };
}

/** The comments as marks on the time bar. @param {{store: CommentStore, head: PlayHead}} marks */
export function CommentMarks({ store: { comments }, head }) {
  return h(
    "div",
    { class: "event-marks comment-marks", "aria-hidden": "true" },
    comments.value.map(({ id, t: at }) => h("i", { key: id, style: `left: ${head.share(at)}%` })),
  );
}

/**
 * @param {{store: CommentStore, head: PlayHead | null}} card head: null without a replay, then comments can only be
 *   read
 */
export function CommentsCard({ store, head }) {
  const comments = store.comments.value;
  return h(
    "section",
    { class: "card stack comments-card" },
    h("h2", { tabindex: -1, ref: store.heading }, t("comments-title")),
    h("p", { class: "quiet", hidden: comments.length > 0 }, t("comments-none")),
    h(
      "ol",
      { class: "comments", hidden: !comments.length },
      comments.map((comment) => h(Comment, { key: comment.id, comment, store, head })),
    ),
    head
      ? h(NewComment, { store, head })
      : h("p", { class: "quiet small", hidden: !comments.length }, t("comments-lost")),
  );
}

/** @param {{comment: CommentView, store: CommentStore, head: PlayHead | null}} item */
function Comment({ comment, store, head }) {
  const { id, person, is_own: isOwn, t: at, revisions } = comment;
  const { app, fresh, heading, change } = store;
  const isHere = useComputed(() => head !== null && Math.abs(at - head.t) < NEAR);
  const { isOpen, open, close, buttonRef } = useOpenForm();
  const [newest, ...earlier] = revisions;
  const values = { t: number(at, 1), person };
  /** @param {string} text */
  const send = (text) => change(() => app.api.put(`/comments/${id}`, { text }), t("comments-revised"));
  const withdraw = async () => {
    if (await change(() => app.api.remove(`/comments/${id}`), t("comments-withdrawn"))) heading.current?.focus();
  };
  const kind = isHere.value ? "is-here" : undefined;
  if (isOpen) {
    const form = { ...formAt(at), text: newest.text, action: t("comments-save"), send, onClose: close };
    const button = h("button", { type: "button", class: "btn", onClick: withdraw }, t("comments-withdraw"));
    return h("li", { class: kind }, h(TextForm, form, button));
  }
  const words = { person, moment: moment(newest.written) };
  const reviseButton = {
    type: /** @type {const} */ ("button"),
    class: "btn bare small",
    "aria-label": t("comments-change-label", values),
    ref: buttonRef,
    onClick: open,
  };
  return h(
    "li",
    { class: kind },
    h(
      "div",
      { class: "spread" },
      h(Moment, { head, comment, isHere: isHere.value }),
      h("span", { class: "quiet small grow" }, t(earlier.length ? "comments-by-revised" : "comments-by", words)),
      fresh.has(id) && h("span", { class: "tag att" }, t("comments-new")),
    ),
    h("p", { class: "own-words" }, newest.text),
    isOwn && h("button", reviseButton, t("comments-change")),
    h(EarlierTexts, {
      title: t("comments-history", { count: earlier.length }),
      earlier: earlier.map(({ text, written }) => ({ text, written, byline: moment(written) })),
    }),
  );
}

/**
 * The moment of a comment; with a replay, a tap goes there.
 * @param {{head: PlayHead | null, comment: CommentView, isHere: boolean}} moment isHere: whether the replay shows it
 */
function Moment({ head, comment: { t: at, person }, isHere }) {
  const values = { t: number(at, 1), person };
  const words = t("comments-at", values);
  if (!head) return h("b", {}, words);
  /** @param {MouseEvent} event */
  const show = ({ detail: taps }) => {
    go(head, at);
    if (taps > 0) showPicture(); // somebody with a keyboard keeps the focus in sight instead
  };
  return h(
    "button",
    {
      type: "button",
      class: "btn bare small moment",
      "aria-label": t("comments-go", values),
      "aria-current": isHere ? "true" : undefined,
      onClick: show,
    },
    words,
  );
}

/**
 * A form to write at the moment that the replay shows; opening it pauses the replay.
 * @param {{store: CommentStore, head: PlayHead}} form
 */
function NewComment({ store: { app, trial, change }, head }) {
  const { isOpen, open, close, buttonRef } = useOpenForm();
  const place = useOpening(isOpen, "textarea");
  const at = useRef(0); // s: the moment that was shown when it was opened
  const write = () => {
    head.pause();
    at.current = head.t;
    open();
  };
  if (!isOpen) {
    const button = { type: /** @type {const} */ ("button"), class: "btn small", ref: buttonRef, onClick: write };
    return h("div", { ref: place }, h("button", button, t("comments-write")));
  }
  const { current: shown } = at;
  const form = {
    ...formAt(shown),
    hint: t("comments-hint"),
    action: t("comments-add"),
    /** @param {string} text */
    send: (text) => change(() => app.api.post(`/trials/${trial}/comments`, { t: shown, text }), t("comments-added")),
    onClose: close,
  };
  return h("div", { ref: place }, h(TextForm, form));
}

/** The words and the limit of the form for a comment. @param {number} at s of the trial */
const formAt = (at) => ({
  label: t("comments-text", { t: number(at, 1) }),
  longest: limitsOf("NewComment", "text").longest,
});

/** Scroll back to the picture: on a phone the list stands far below it. */
function showPicture() {
  const picture = document.querySelector(".replay-picture");
  const page = picture?.closest("main");
  if (picture && page && picture.getBoundingClientRect().top < page.getBoundingClientRect().top - 1)
    picture.scrollIntoView();
}
