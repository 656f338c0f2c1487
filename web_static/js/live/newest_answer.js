/** What the server answers to a question that a page asks again after news. */
import { signal } from "../preact.js";

/**
 * A signal of the newest answer: a late answer to an earlier question changes nothing, nor does a failure.
 * @template Answer
 * @param {import("../main.js").App} app @param {AbortSignal} left of the page
 * @param {Answer} first the answer that the page has already
 * @param {() => Promise<Answer>} ask @param {string[]} news what changes on the server before it is asked again
 */
export function newestAnswer(app, left, first, ask, news) {
  const newest = signal(first);
  let questions = 0;
  app.live.addEventListener(
    "changed",
    async ({ detail }) => {
      if (!news.includes(detail)) return;
      const question = ++questions;
      const answer = await ask().catch(() => null);
      if (answer && question === questions) newest.value = answer;
    },
    { signal: left },
  );
  return newest;
}
