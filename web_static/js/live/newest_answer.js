/** What the server answers to a question that a page asks again after news that concerns it. */
import { signal } from "../preact.js";
import { onNews } from "./news.js";

/**
 * A signal of the newest answer: a late answer to an earlier question changes nothing, nor does a failure, nor null.
 * @template Answer
 * @param {import("../main.js").App} app @param {AbortSignal} left of the page
 * @param {Answer} first the answer that the page has already
 * @param {() => Promise<Answer | null>} ask
 * @param {import("./news.js").Interest} interest the news after which it is asked again
 */
export function newestAnswer(app, left, first, ask, interest) {
  const newest = signal(first);
  let questions = 0;
  onNews(app, left, interest, async () => {
    const question = ++questions;
    const answer = await ask().catch(() => null);
    if (answer && question === questions) newest.value = answer;
  });
  return newest;
}
