/**
 * The Drive page before a trial: one task with its button; everything else has a page of its own.
 * @import { App } from "../../main.js"
 * @import { EquipmentView, NextTaskView, PatientView, ScreensView } from "types/api"
 * @import { VNode } from "../../preact.js"
 * @import { Task } from "./task_words.js"
 * @typedef {{task: Task, reason: "chosen" | NextTaskView["reason"]}} TaskChoice a task, and why it is shown
 * @typedef {NonNullable<Awaited<ReturnType<typeof taskStore>>>} TaskStore
 */
import { newestAnswer } from "../../live/newest_answer.js";
import { warningsPlace } from "../../results/control_warnings.js";
import { drawFoot, drawPage, Fragment, h, signal, useFocusWithin } from "../../preact.js";
import { wayBeforeDriving } from "./obstacle_link.js";
import { PlanPlace } from "./plan_place.js";
import { screenWords } from "./screen_words.js";
import { findTask, taskLink, taskWords } from "./task_words.js";
import { chooseView } from "../../view/view_bar.js";
import { canDrawIn3d } from "../../view/webgl.js";
import { today } from "../../widgets/format.js";
import { Made } from "../../widgets/made.js";
import { t } from "../../texts.js";

/**
 * @param {App} app @param {HTMLElement} root @param {PatientView} patient @param {string[]} named floor plan and path
 * that a person has chosen; without them, a task is proposed @param {AbortSignal} left
 */
export async function showTask(app, root, patient, named, left) {
  const store = await taskStore(app, patient.id, named, left);
  if (!store) return;
  drawPage(root, h(Page, { store }));
  drawFoot(root, h(Foot, { store }));
}

/**
 * What the page shows, as news change it; null when another page is shown.
 * @param {App} app @param {number} patient id @param {string[]} named @param {AbortSignal} left
 */
async function taskStore(app, patient, [floorplan, path], left) {
  const mayDrive = app.me?.role !== "reviewer";
  const readProposal = () => app.api.get(`/patients/${patient}/next-task`);
  const [plans, proposal, equipmentNow, chairs, screensNow] = await Promise.all([
    app.api.get("/floorplans"),
    readProposal(),
    app.api.get("/equipment"),
    app.api.get("/chairs"),
    mayDrive ? app.api.get("/patient-screen").catch(() => null) : null,
    app.readSession().catch(() => null), // what stands in the way of a trial now
  ]);
  if (left.aborted) return null;
  if (chairs.chosen !== null) {
    location.replace("#/drive/chair");
    return null;
  }
  const chosen = findTask(plans, floorplan, path);
  /** @param {NextTaskView} next @returns {TaskChoice | null} null: it is in a plan that is not listed */
  const choiceOf = (next) => {
    const task = chosen ?? findTask(plans, next.floorplan, next.path);
    return task ? { task, reason: chosen ? "chosen" : next.reason } : null;
  };
  const first = choiceOf(proposal);
  if (!first) throw new Error(t("drive-no-path", { path: proposal.path }));
  /** The choice after news of trials; where a trial runs by now, the page is shown anew. */
  const chooseAgain = async () => {
    const [next, trials] = await Promise.all([readProposal(), app.api.get(`/trials?patient=${patient}`)]);
    const again = trials.some(({ status }) => status === "running") ? null : choiceOf(next);
    if (!again && !left.aborted) app.show();
    return again;
  };
  const choice = newestAnswer(app, left, first, chooseAgain, { what: ["trial"], patient });
  const equipment = newestAnswer(app, left, equipmentNow, () => app.api.get("/equipment"), { what: ["equipment"] });
  // Null for somebody who does not drive, and when the screens could not be read.
  const readScreens = async () => screensNow && app.api.get("/patient-screen");
  const screens = newestAnswer(app, left, screensNow, readScreens, { what: ["screens"] });
  const obstacle = signal(app.session?.obstacle ?? null); // what the start of a trial would be refused for
  const has3d = canDrawIn3d();
  app.addEventListener("session", () => void (obstacle.value = app.session?.obstacle ?? null), { signal: left });
  const start = () => {
    const { plan, path: way } = choice.value.task;
    if (!has3d) chooseView("plan");
    app.requestTrial({ floorplan: plan.name, path: way.name });
  };
  const state = { choice, equipment, screens, obstacle };
  return { app, left, patient, mayDrive, has3d, dynamics: chairs.dynamics, ...state, start };
}

/** @param {{store: TaskStore}} page */
function Page({ store: { app, left, patient, mayDrive, has3d, dynamics, choice, screens } }) {
  const { task, reason } = choice.value;
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, t("drive-title")),
    h("p", { class: "lead" }, t(`drive-why-${reason}`)),
    !has3d && h("p", { class: "card no-view", role: "status" }, t("picture-choose")),
    h(
      "section",
      { class: "card task-card" },
      h("div", { class: "words" }, h("h2", {}, task.path.title), h("p", { class: "quiet" }, taskWords(task))),
      h(PlanPlace, { app, task, left }),
    ),
    h(Made, { left, make: (gone) => warningsPlace(app, patient, gone) }),
    h(
      "nav",
      { class: "drive-places", "aria-label": t("drive-places") },
      placeLink("test", "#/interface_test", h("span", {}, t("drive-place-test-state"))),
      placeLink("chair", taskLink("chairs", task), h("span", {}, t(`drive-place-chair-${dynamics}`))),
      screens.value && placeLink("screen", taskLink("screen", task), screenState(screens.value)),
      mayDrive && placeLink("plans", "#/plans", h("span", {}, t("drive-place-plans-state"))),
    ),
  );
}

/** @param {"test" | "chair" | "screen" | "plans"} name @param {string} href @param {VNode<any>} state */
function placeLink(name, href, state) {
  return h("a", { class: "card", href }, h("b", {}, t(`drive-place-${name}`)), state);
}

/** How many screens the patient has, and whether each has a picture to drive by. @param {ScreensView} view */
function screenState({ screens }) {
  const { words, isBad } = screenWords(screens);
  return h("span", { class: isBad ? "att" : undefined }, words);
}

/** Who moves, the way to another task, the start of the trial or what it lacks. @param {{store: TaskStore}} foot */
function Foot({ store }) {
  const { app, choice, equipment, obstacle, mayDrive } = store;
  useFocusWithin(".foot", ".foot .btn.go");
  const { shirt } = equipment.value;
  const way = wayBeforeDriving(shirt, obstacle.value);
  return h(
    Fragment,
    {},
    h(
      "span",
      { class: "grow" },
      way ? h("b", {}, way.message) : bodyWords(equipment.value),
      " ",
      app.me?.demo &&
        mayDrive &&
        shirt?.kind === "simulator" &&
        h(
          Fragment,
          {},
          h("button", { type: "button", class: "btn bare small", onClick: () => moveByCamera(app) }, t("drive-camera")),
          h("span", { class: "quiet small" }, t("drive-camera-hint"), " "),
        ),
      mayDrive &&
        !obstacle.value &&
        shirt?.kind === "simulator" &&
        h("a", { class: "btn bare small", href: "#/shirt" }, t("drive-body-change")),
    ),
    h("a", { class: "btn", href: taskLink("tasks", choice.value.task) }, t("drive-choose")),
    mayDrive && way && h("a", { class: "btn go large", href: way.href }, way.go),
    mayDrive &&
      !way &&
      h(
        "button",
        { type: "button", class: "btn go large", onClick: store.start },
        t(store.has3d ? "drive-start" : "drive-start-plan"),
      ),
  );
}

/**
 * Take the camera of this device as the shirt, and show it. Who taps, having read that it is recorded, consents to it.
 * @param {App} app of a demonstration
 */
async function moveByCamera(app) {
  const { patient, consents_to_recording: consents } = app.session ?? {};
  await app.toasts.attempt(async () => {
    if (patient && !consents) await app.api.put(`/patients/${patient.id}/consents/recording`, { given: today() });
    await app.api.put("/equipment/shirt", { kind: "camera" });
    (await import("../../camera/camera.js")).startCamera();
    app.go("#/shirt");
  });
}

/** @param {EquipmentView} equipment */
function bodyWords({ shirt, body }) {
  if (shirt?.kind !== "simulator" || !body) return t("drive-body-patient");
  return t(body.kind === "person" ? `drive-body-person-${body.skill}` : `drive-body-${body.kind}`);
}
