/**
 * Drive: the next task, the trial, what it came to.
 * @import { App } from "../../main.js"
 * @import { TrialView } from "types/api"
 * @typedef {{floorplan: string, path: string}} Place where to drive
 */
import { AdaptLink } from "./adapt_link.js";
import { onNews } from "../../live/news.js";
import { h } from "../../preact.js";
import { emptyPage, patientHere } from "../../shell/nobody.js";
import { readTrial, showTrialOver } from "../../results/trial_over.js";
import { showTask } from "./task_page.js";
import { showTrial } from "./trial_view.js";
import { t } from "../../texts.js";

/**
 * The pages below this one, each loaded when it is opened; each gets the task to go back to.
 * @type {Record<string, (...given: [App, HTMLElement, string[], AbortSignal]) => Promise<unknown>>}
 */
export const BELOW = {
  tasks: async (...given) => (await import("./task_chooser.js")).showChooser(...given),
  chairs: async (...given) => (await import("./below.js")).showChairs(...given),
  screen: async (...given) => (await import("./below.js")).showScreen(...given),
};

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal, rest }) {
  const here = patientHere(app, root);
  if (!here) return;
  const trials = await app.api.get(`/trials?patient=${here.patient.id}`);
  if (signal.aborted) return;
  const running = trials.find(({ status }) => status === "running");
  const where = app.takeTrialRequest();
  const place = running ? { floorplan: running.floorplan, path: running.path } : where;
  if (place) return drive(app, root, running, place, signal);
  if (rest[0] === "over") return over(app, root, rest[1], signal);
  if (!app.session?.has_profile)
    return emptyPage(root, t("drive-none-title"), t("drive-none-lead"), "#/calibrate", t("drive-none-go"));
  if (rest[0] === "chair") return (await import("../chair/chair.js")).show(app, root, { signal, rest });
  const [name, ...task] = rest;
  if (Object.hasOwn(BELOW, name ?? "")) return BELOW[name](app, root, task, signal);
  return showTask(app, root, here.patient, name === "task" ? task : [], signal);
}

/**
 * Show a trial: one that runs already, or one that is started as soon as there is a picture to drive by.
 * @param {App} app @param {HTMLElement} root @param {TrialView | undefined} running @param {Place} where
 * @param {AbortSignal} signal
 */
async function drive(app, root, running, where, signal) {
  const [plan, equipment] = await Promise.all([
    app.api.get(`/floorplans/${where.floorplan}`),
    app.api.get("/equipment"),
  ]);
  if (signal.aborted) return;
  let trial = running;
  const path = plan.paths.find((one) => one.name === where.path);
  if (!path) throw new Error(t("drive-no-path", { path: where.path }));
  const isVisitor = equipment.shirt?.kind === "simulator" && equipment.body?.kind === "visitor";
  const lookWhetherOver = async () => {
    const { id, patient_id: patient } = trial ?? {};
    if (!id) return;
    const trials = await app.api.get(`/trials?patient=${patient}`).catch(() => []);
    const now = trials.find((one) => one.id === id);
    if (!signal.aborted && now && now.status !== "running") app.go(`#/drive/over/${id}`);
  };
  onNews(app, signal, { what: ["trial"], trial: running?.id }, lookWhetherOver);
  const view = showTrial(app, root, { plan, path, isVisitor }, signal);
  if (running) return view.begin(running);
  view.picture.ready.then(async () => {
    if (signal.aborted) return;
    const hasBegun = await app.toasts.attempt(async () => {
      trial = await app.api.post("/trials", { ...where, screen: app.screen.word, picture: view.picture.shows });
      view.begin(trial);
      await lookWhetherOver();
      return true;
    });
    if (!hasBegun) app.go(`#/drive/task/${where.floorplan}/${where.path}`);
  });
}

/** @param {App} app @param {HTMLElement} root @param {string} id of the trial @param {AbortSignal} signal */
async function over(app, root, id, signal) {
  const read = await readTrial(app.api, id);
  const next = await app.api.get(`/patients/${read.trial.patient_id}/next-task?source=${read.trial.source.group}`);
  if (signal.aborted) return;
  const { patient_id: patient, patient_code: code, session_number: number } = read.trial;
  app.setSubject({ patient, code, sessions: [number] });
  /** @param {Place} where @param {boolean} isMain @param {string} words */
  const button = (where, isMain, words) =>
    h("button", { type: "button", class: isMain ? "btn go" : "btn", onClick: () => app.requestTrial(where) }, words);
  const isHarder = next.reason === "next level";
  showTrialOver(app, root, read, {
    left: signal,
    actions: (trial) => [
      h(AdaptLink, { app, trial, left: signal }),
      h("a", { class: "btn", href: "#/drive" }, t("over-other")),
      button({ floorplan: trial.floorplan, path: trial.path_name }, !isHarder, t("over-next")),
      isHarder && button({ floorplan: next.floorplan, path: next.path }, true, t("over-harder")),
    ],
  });
}
