/**
 * Marks beside trials and sessions with comments that this person has not read; they follow what is written elsewhere.
 * @import { CommentView } from "types/api"
 */
import { t } from "../texts.js";
import { h, put } from "../widgets/dom.js";

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
    if (detail !== "record" && detail !== "everything") return;
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
