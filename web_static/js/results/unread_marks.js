/**
 * Marks beside trials and sessions with comments that this person has not read; they follow what is written elsewhere.
 * @import { CommentView } from "types/api"
 * @import { ReadonlySignal } from "../preact.js"
 */
import { newestAnswer } from "../live/newest_answer.js";
import { h as draw } from "../preact.js";
import { t } from "../texts.js";
import { h, put } from "../widgets/dom.js";

const NEWS = ["record", "everything"]; // after which a comment may be new, or read

/**
 * @param {import("../main.js").App} app @param {number} patient id @param {AbortSignal} signal
 * @returns {Promise<UnreadMark>}
 * @typedef {(what: Partial<CommentView>) => HTMLElement} UnreadMark the mark of the comments with these fields
 */
export async function unreadMarks(app, patient, signal) {
  const ask = () => app.api.get(`/comments?patient=${patient}`);
  let unread = await ask().catch(() => /** @type {CommentView[]} */ ([])); // what is listed stands without its marks
  /** @type {{element: HTMLElement, belongs: (one: CommentView) => boolean}[]} */
  let marks = [];
  /** @param {typeof marks[number]} mark */
  const draw = ({ element, belongs }) => {
    const count = unread.filter(belongs).length;
    put(element, count > 0 && h("span", { class: "tag att" }, t("comments-unread", { count })));
  };
  /** @param {CustomEvent<string>} event */
  const read = async ({ detail }) => {
    if (!NEWS.includes(detail)) return;
    unread = await ask().catch(() => unread);
    if (signal.aborted) return;
    marks = marks.filter(({ element }) => element.isConnected); // lists are drawn again
    marks.forEach(draw);
  };
  app.live.addEventListener("changed", read, { signal });
  return (what) => {
    const fields = /** @type {[keyof CommentView, unknown][]} */ (Object.entries(what));
    const mark = {
      element: h("span", { class: "unread" }),
      belongs: (/** @type {CommentView} */ one) => fields.every(([name, value]) => one[name] === value),
    };
    marks.push(mark);
    draw(mark);
    return mark.element;
  };
}

/**
 * The comments on a patient's trials that this person has not read; without an answer none, so that lists can be shown.
 * @param {import("../main.js").App} app @param {number} patient id @param {AbortSignal} left
 */
export async function unreadComments(app, patient, left) {
  const ask = () => app.api.get(`/comments?patient=${patient}`);
  const first = await ask().catch(() => /** @type {CommentView[]} */ ([]));
  return newestAnswer(app, left, first, ask, NEWS);
}

/**
 * How many of these comments have the fields of `about`.
 * @param {{comments: ReadonlySignal<CommentView[]>, about: Partial<CommentView>}} mark
 */
export function UnreadCount({ comments, about }) {
  const fields = /** @type {[keyof CommentView, unknown][]} */ (Object.entries(about));
  const count = comments.value.filter((comment) => fields.every(([name, value]) => comment[name] === value)).length;
  const mark = count > 0 && draw("span", { class: "tag att" }, t("comments-unread", { count }));
  return draw("span", { class: "unread" }, mark);
}
