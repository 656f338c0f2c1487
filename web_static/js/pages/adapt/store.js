/**
 * What would change of a patient's map, the versions of that map, and what a person can do about them.
 * @import { App } from "../../main.js"
 * @import { AdaptationView } from "types/api"
 * @import { MapVersion } from "types/documents"
 * @typedef {AdaptationView["mode"]} Mode
 * @typedef {Awaited<ReturnType<typeof adaptStore>>} AdaptStore
 */
import { failureWords } from "../../api.js";
import { onNews } from "../../live/news.js";
import { signal } from "../../preact.js";
import { t } from "../../texts.js";

/** The proposal that waits for a person; null when none does. @param {AdaptationView} view */
export const waiting = ({ proposal }) => (proposal?.changes && proposal.applied === null ? proposal : null);

/** Whether a look at the last trials can begin now. @param {AdaptationView} view */
export const mayLook = (view) => !waiting(view) && !view.looking && view.refusal === null;

/** @param {App} app @param {number} patient id @param {AbortSignal} left of the page */
export async function adaptStore(app, patient, left) {
  const ask = () => Promise.all([app.api.get("/adaptation"), app.api.get(`/patients/${patient}/maps`)]);
  const [first, versions] = await ask();
  const view = signal(first);
  const maps = signal(/** @type {MapVersion[]} */ (versions));
  const wanted = signal(/** @type {Mode | null} */ (null)); // a mode that was chosen and is not answered yet
  const isBusy = signal(false); // a change is under way
  const problem = signal(""); // why a change was refused
  let questions = 0;
  let newest = 0; // the question whose answer is shown

  const read = async () => {
    const number = ++questions;
    const [now, versionsNow] = await ask();
    if (left.aborted || number < newest) return;
    newest = number;
    view.value = now;
    maps.value = /** @type {MapVersion[]} */ (versionsNow);
  };
  const readAgain = () => read().catch(() => null);
  /**
   * Make a change, and read again how things are; null when it is refused.
   * @param {() => Promise<AdaptationView>} make
   */
  const change = async (make) => {
    problem.value = "";
    isBusy.value = true;
    try {
      const answer = await make();
      await read();
      return answer;
    } catch (error) {
      await readAgain();
      problem.value = failureWords(error);
      return null;
    } finally {
      isBusy.value = false;
    }
  };
  /** @param {Mode} mode */
  const choose = async (mode) => {
    wanted.value = mode;
    await change(() => app.api.put("/adaptation", { mode }));
    if (wanted.value === mode) wanted.value = null;
  };
  const look = () => change(() => app.api.post("/adaptation/propose"));
  /** @param {string} proposal its id */
  const dismiss = (proposal) => change(() => app.api.post("/adaptation/dismiss", { proposal }));
  /** @param {string} proposal its id */
  const apply = async (proposal) => {
    const answer = await change(() => app.api.post("/adaptation/apply", { proposal }));
    if (!answer) return;
    app.toasts.show(t("adapt-applied-toast", { version: answer.version ?? "" }), { action: t("undo"), run: back });
  };
  const back = async () => {
    const to = (await app.api.get("/adaptation")).back_to;
    const answer = await change(() => app.api.post("/adaptation/back"));
    if (answer) app.toasts.show(t("adapt-back-toast", { to: to ?? "", version: answer.version ?? "" }));
  };
  let moment = "";
  // What may be applied depends on the chair too: no news says that it stands again, or that a stop was taken back.
  app.live.addEventListener(
    "tick",
    ({ detail: { state, v } }) => {
      const before = moment;
      moment = `${state} ${v ? "moves" : "stands"}`;
      if (before && moment !== before) readAgain();
    },
    { signal: left },
  );
  onNews(app, left, { what: ["adaptation", "controls", "trial", "drive", "equipment"], patient }, readAgain);
  const mayChange = app.me?.role !== "reviewer";
  return { view, maps, wanted, isBusy, problem, mayChange, choose, look, dismiss, apply, back };
}
