/**
 * Marks beside trials and sessions with comments that this person has not read; they follow what is written elsewhere.
 * @import { CommentView } from "types/api"
 * @import { ReadonlySignal } from "../preact.js"
 */
import { newestAnswer } from "../live/newest_answer.js";
import { h } from "../preact.js";
import { t } from "../texts.js";

/**
 * The comments on a patient's trials that this person has not read; without an answer none, so that lists can be shown.
 * @param {import("../main.js").App} app @param {number} patient id @param {AbortSignal} left
 */
export async function unreadComments(app, patient, left) {
  const ask = () => app.api.get(`/comments?patient=${patient}`);
  const first = await ask().catch(() => /** @type {CommentView[]} */ ([]));
  return newestAnswer(app, left, first, ask, { what: ["comment"], patient });
}

/**
 * How many of these comments have the fields of `about`.
 * @param {{comments: ReadonlySignal<CommentView[]>, about: Partial<CommentView>}} mark
 */
export function UnreadCount({ comments, about }) {
  const fields = /** @type {[keyof CommentView, unknown][]} */ (Object.entries(about));
  const count = comments.value.filter((comment) => fields.every(([name, value]) => comment[name] === value)).length;
  const mark = count > 0 && h("span", { class: "tag att" }, t("comments-unread", { count }));
  return h("span", { class: "unread" }, mark);
}
