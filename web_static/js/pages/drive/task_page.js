/**
 * The Drive page before a trial: one task with its button; everything else has a page of its own.
 * @import { App } from "../../main.js"
 * @import { EquipmentView, ObstacleView, PatientView, ScreensView } from "types/api"
 * @import { Task } from "./task_words.js"
 */
import { warningsPlace } from "../../results/control_warnings.js";
import { h, put, write } from "../../widgets/dom.js";
import { planPicture } from "../../plan/plan_svg.js";
import { wayBeforeDriving } from "./obstacle_link.js";
import { screenWords } from "./screen_words.js";
import { findTask, taskLink, taskWords } from "./task_words.js";
import { chooseView } from "../../view/view_bar.js";
import { canDrawIn3d } from "../../view/webgl.js";
import { t } from "../../texts.js";

/**
 * @param {App} app @param {HTMLElement} root @param {PatientView} patient @param {string[]} named floor plan and path
 * that a person has chosen; without them, a task is proposed @param {AbortSignal} signal
 */
export async function showTask(app, root, patient, [floorplan, path], signal) {
  const mayDrive = app.me?.role !== "reviewer";
  const source = app.practice ? "simulated" : "worn";
  const readProposal = () => app.api.get(`/patients/${patient.id}/next-task?source=${source}`);
  const readWhatIsNext = async () => {
    const [next, trials] = await Promise.all([readProposal(), app.api.get(`/trials?patient=${patient.id}`)]);
    return { proposal: next, isRunning: trials.some(({ status }) => status === "running") };
  };
  const [plans, proposal, equipment, chairs, screens] = await Promise.all([
    app.api.get("/floorplans"),
    readProposal(),
    app.api.get("/equipment"),
    app.api.get("/chairs"),
    mayDrive ? app.api.get("/patient-screen").catch(() => null) : null,
    app.readSession().catch(() => null), // what stands in the way of a trial now
  ]);
  if (signal.aborted) return;
  if (chairs.chosen !== null) return location.replace("#/drive/chair");
  const chosen = findTask(plans, floorplan, path);
  const task = chosen ?? findTask(plans, proposal.floorplan, proposal.path);
  if (!task) throw new Error(t("drive-no-path", { path: proposal.path }));
  const has3d = canDrawIn3d();
  const start = () => {
    if (!has3d) chooseView("plan");
    app.requestTrial({ floorplan: task.plan.name, path: task.path.name });
  };
  whenOther(app, ["trial", "everything"], { proposal, isRunning: false }, readWhatIsNext, signal);
  const foot = h("div", { class: "foot" });
  /** @param {EquipmentView} now @param {ObstacleView | null} obstacle what the start of a trial would be refused for */
  const drawFoot = (now, obstacle) => {
    const hadFocus = foot.contains(document.activeElement);
    put(
      foot,
      h(
        "span",
        { class: "grow" },
        bodyWords(now, obstacle),
        " ",
        mayDrive &&
          !obstacle &&
          now.shirt?.kind === "simulator" &&
          h("a", { class: "btn bare small", href: "#/shirt" }, t("drive-body-change")),
      ),
      h("a", { class: "btn", href: taskLink("tasks", task) }, t("drive-choose")),
      mayDrive && mainButton(now, obstacle, start, has3d),
    );
    if (hadFocus) /** @type {HTMLElement | null} */ (foot.querySelector(".btn.go"))?.focus();
  };
  let shown = app.session?.obstacle ?? null;
  const followObstacle = async () => {
    const obstacle = app.session?.obstacle ?? null;
    if (!isOther(obstacle, shown)) return;
    shown = obstacle;
    const now = await app.api.get("/equipment").catch(() => equipment);
    if (!signal.aborted && shown === obstacle) drawFoot(now, obstacle);
  };
  drawFoot(equipment, shown);
  app.addEventListener("session", followObstacle, { signal });
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("drive-title")),
      h("p", { class: "lead" }, t(`drive-why-${chosen ? "chosen" : proposal.reason}`)),
      !has3d && h("p", { class: "card no-view", role: "status" }, t("picture-choose")),
      taskCard(app, task, signal),
      warningsPlace(app, patient.id, signal),
      h(
        "nav",
        { class: "drive-places", "aria-label": t("drive-places") },
        placeLink("test", "#/interface_test", h("span", {}, t("drive-place-test-state"))),
        placeLink("chair", taskLink("chairs", task), h("span", {}, t(`drive-place-chair-${chairs.dynamics}`))),
        screens && placeLink("screen", taskLink("screen", task), screenState(app, screens, signal)),
        mayDrive && placeLink("plans", "#/plans", h("span", {}, t("drive-place-plans-state"))),
      ),
    ),
    foot,
  );
}

/**
 * Show the page anew when, after news, something is read that differs from what is shown.
 * @template T @param {App} app @param {string[]} news names of what changes it @param {T} shown
 * @param {() => Promise<T>} read @param {AbortSignal} signal
 */
function whenOther(app, news, shown, read, signal) {
  const look = async () => {
    const now = await read().catch(() => shown);
    if (!signal.aborted && isOther(now, shown)) app.show();
  };
  app.live.addEventListener("changed", ({ detail }) => news.includes(detail) && look(), { signal });
}

/** @param {unknown} now @param {unknown} shown */
const isOther = (now, shown) => JSON.stringify(now) !== JSON.stringify(shown);

/**
 * The start of the trial, or the way to what it lacks.
 * @param {EquipmentView} equipment @param {ObstacleView | null} obstacle @param {() => void} start @param {boolean} has3d
 */
function mainButton({ shirt }, obstacle, start, has3d) {
  const way = wayBeforeDriving(shirt, obstacle);
  if (way) return h("a", { class: "btn go large", href: way.href }, way.go);
  return h(
    "button",
    { type: "button", class: "btn go large", onclick: start },
    t(has3d ? "drive-start" : "drive-start-plan"),
  );
}

/** The task: its name, where it is, and its way over the plan. @param {App} app @param {Task} task @param {AbortSignal} signal */
function taskCard(app, task, signal) {
  const picture = h("div", { class: "plan-place" });
  app.api
    .get(`/floorplans/${task.plan.name}`)
    .then((plan) => {
      const request = plan.paths.find(({ name }) => name === task.path.name);
      if (signal.aborted || !request) return;
      const label = t("drive-plan-label", { plan: plan.title, path: request.title });
      put(picture, planPicture(plan, request.points, { label, request }).element);
    })
    .catch(() => {}); // the start of the trial says what is wrong with the plan
  return h(
    "section",
    { class: "card task-card" },
    h("div", { class: "words" }, h("h2", {}, task.path.title), h("p", { class: "quiet" }, taskWords(task))),
    picture,
  );
}

/** @param {"test" | "chair" | "screen" | "plans"} name @param {string} href @param {HTMLElement} state */
function placeLink(name, href, state) {
  return h("a", { class: "card", href }, h("b", {}, t(`drive-place-${name}`)), state);
}

/** How many screens the patient has, and whether each has a picture to drive by. @param {App} app @param {ScreensView} read @param {AbortSignal} signal */
function screenState(app, read, signal) {
  const state = h("span", {});
  /** @param {ScreensView} now */
  const show = ({ screens }) => {
    const { words, isBad } = screenWords(screens);
    state.className = isBad ? "att" : "";
    write(state, words);
  };
  show(read);
  const again = () => app.api.get("/patient-screen").then(show, () => {});
  app.live.addEventListener("changed", ({ detail }) => ["screens", "everything"].includes(detail) && again(), {
    signal,
  });
  return state;
}

/** @param {EquipmentView} equipment @param {ObstacleView | null} obstacle */
function bodyWords({ shirt, body }, obstacle) {
  const way = wayBeforeDriving(shirt, obstacle);
  if (way || !shirt) return h("b", {}, way?.message);
  if (shirt.kind !== "simulator" || !body) return t("drive-body-patient");
  return t(body.kind === "person" ? `drive-body-person-${body.skill}` : `drive-body-${body.kind}`);
}
