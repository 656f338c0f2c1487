/**
 * What the record of a session shows, and how a person changes it.
 * @import { SessionRecordView } from "types/api"
 * @typedef {ReturnType<typeof recordStore>} RecordStore
 */
import { failureWords } from "../../api.js";
import { newestAnswer } from "../../live/newest_answer.js";
import { computed, createRef } from "../../preact.js";

/** Whether the person who is signed in may write records and consents. @param {import("../../main.js").App} app */
export function mayWrite(app) {
  return app.me?.role === "owner" || app.me?.role === "clinician";
}

/** @param {import("../../main.js").App} app @param {SessionRecordView} first @param {AbortSignal} left */
export function recordStore(app, first, left) {
  /** @type {import("../../live/news.js").Interest} */
  const interest = { what: ["record", "trial", "session"], session: first.id };
  const record = newestAnswer(app, left, first, () => app.api.get(`/sessions/${first.id}`), interest);
  /** Whether goal, notes and scales can be changed: the sign-off locks them. */
  const mayChange = computed(() => mayWrite(app) && !record.value.sign_off);
  const heading = /** @type {{current: HTMLElement | null}} */ (createRef());
  /**
   * Change the record, and return whether it was done; a refusal is shown. The heading gets the focus after a sign-off
   * or an unlocking, because these change every card.
   * @param {() => Promise<SessionRecordView>} act @param {string} [message] shown when it was done
   */
  const change = async (act, message) => {
    const wasSigned = Boolean(record.value.sign_off);
    try {
      record.value = await act();
    } catch (error) {
      if (!left.aborted) app.toasts.show(failureWords(error));
      return false;
    }
    if (left.aborted) return true;
    if (message) app.toasts.show(message);
    if (wasSigned !== Boolean(record.value.sign_off)) heading.current?.focus();
    return true;
  };
  return { app, record, mayChange, heading, change };
}
