/**
 * What changed on the server, and whether it concerns a page.
 * @import { News as ServerNews } from "types/api"
 */

const IDS = /** @type {const} */ (["patient", "session", "trial"]);

/**
 * What changed; an id that is missing or null may be any. The browser adds "everything", after a gap in which it heard
 * of no change, and "sign-in", when the sign-in has ended.
 * @typedef {{what: ServerNews["what"] | "everything" | "sign-in"} & Partial<Omit<ServerNews, "what">>} News
 */

/**
 * What a page shows: of the patient, session or trial whose id is given, otherwise of all.
 * @typedef {{what: News["what"][], patient?: number, session?: number, trial?: number}} Interest
 */

/**
 * Whether a page asks again after some news; "everything" concerns every page.
 * @param {News} news @param {Interest} interest
 */
export function concerns(news, interest) {
  if (news.what === "everything") return true;
  return interest.what.includes(news.what) && IDS.every((name) => mayBeSame(news[name], interest[name]));
}

/**
 * Do it after each news that concerns a page; also now, if some came while the page read its first answers.
 * @param {import("../main.js").App} app @param {AbortSignal} left of the page
 * @param {Interest} interest @param {() => unknown} act
 */
export function onNews(app, left, interest, act) {
  app.live.addEventListener("changed", ({ detail }) => void (concerns(detail, interest) && act()), { signal: left });
  if (app.earlyNews?.some((news) => concerns(news, interest))) act();
}

/** @param {number | null | undefined} id @param {number | undefined} wanted */
const mayBeSame = (id, wanted) => !id || !wanted || id === wanted;
