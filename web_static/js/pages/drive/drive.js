/**
 * Drive: choose a path, drive it, look at what it came to.
 * @import { App } from "../../main.js"
 * @import { EquipmentView, FloorPlan, PatientView, TrialView } from "types/api"
 * @import { Place } from "./plan_chooser.js"
 */
import { adaptLink } from "./adapt_link.js";
import { chairChoice } from "./chair_choice.js";
import { warningsPlace } from "../../results/control_warnings.js";
import { h, put } from "../../widgets/dom.js";
import { emptyPage, patientHere } from "../../shell/nobody.js";
import { patientScreenCard } from "../../widgets/patient_screen_card.js";
import { planChooser } from "./plan_chooser.js";
import { readTrial, showTrialOver } from "../../results/trial_over.js";
import { showTrial } from "./trial_view.js";
import { chooseView } from "../../view/view_bar.js";
import { canDrawIn3d } from "../../view/webgl.js";
import { t } from "../../texts.js";

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
    return emptyPage(root, t("drive.none.title"), t("drive.none.lead"), "#/calibrate", t("drive.none.go"));
  if (rest[0] === "chair") return (await import("../chair/chair.js")).show(app, root, { signal, rest });
  return choose(app, root, here.patient, signal);
}

/** @param {App} app @param {HTMLElement} root @param {PatientView} patient @param {AbortSignal} signal */
async function choose(app, root, patient, signal) {
  const [plans, equipment, chairs] = await Promise.all([
    app.api.get("/floorplans"),
    app.api.get("/equipment"),
    app.api.get("/chairs"),
  ]);
  if (signal.aborted) return;
  if (chairs.chosen !== null) return location.replace("#/drive/chair");
  /** @type {Map<string, Promise<FloorPlan>>} */
  const documents = new Map();
  /** @param {string} name */
  const read = (name) => {
    const document = documents.get(name) ?? app.api.get(`/floorplans/${name}`);
    documents.set(name, document);
    return document;
  };
  const chosenWords = h("button", { type: "button", class: "btn bare chosen-words", title: t("drive.chosen"), onclick: () => chooser.show() });
  const chooser = planChooser(plans, read, (words) => put(chosenWords, words));
  const has3d = canDrawIn3d();
  const start = () => {
    if (!has3d) chooseView("plan");
    app.requestTrial(chooser.chosen());
  };
  const button = h(
    "button",
    { type: "button", class: "btn go large", onclick: start },
    t(has3d ? "drive.start" : "drive.start.plan"),
  );
  app.live.addEventListener("changed", ({ detail }) => detail === "trial" && app.show(), { signal });
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("drive.title")),
      h(
        "p",
        { class: "lead" },
        t("drive.lead"),
        " ",
        app.me?.role !== "reviewer" && h("a", { class: "btn bare small", href: "#/plans" }, t("plans.link")),
      ),
      !has3d && h("p", { class: "card no-view", role: "status" }, t("picture.choose")),
      chairChoice(app, chairs),
      warningsPlace(app, patient.id, signal),
      chooser.element,
      app.me?.role !== "reviewer" && patientScreenCard(app, signal),
    ),
    h(
      "div",
      { class: "foot" },
      h(
        "span",
        { class: "grow" },
        bodyNote(equipment),
        " ",
        (!equipment.shirt || equipment.shirt.kind === "simulator") &&
          h("a", { class: "btn bare small", href: "#/shirt" }, t("drive.body.change")),
      ),
      chosenWords,
      button,
    ),
  );
}

/** @param {EquipmentView} equipment */
function bodyNote({ shirt, body }) {
  if (!shirt) return t("lamp.shirt.none");
  if (shirt.kind !== "simulator" || !body) return t("drive.body.patient");
  return t(body.kind === "person" ? `drive.body.person.${body.skill}` : `drive.body.${body.kind}`);
}

/**
 * Show a trial: one that runs already, or one that is started as soon as there is a picture to drive by.
 * @param {App} app @param {HTMLElement} root @param {TrialView | undefined} running @param {Place} where
 * @param {AbortSignal} signal
 */
async function drive(app, root, running, where, signal) {
  const [plan, equipment] = await Promise.all([app.api.get(`/floorplans/${where.floorplan}`), app.api.get("/equipment")]);
  if (signal.aborted) return;
  let trial = running;
  const path = plan.paths.find((one) => one.name === where.path);
  if (!path) throw new Error(t("drive.no-path", { path: where.path }));
  const isVisitor = equipment.shirt?.kind === "simulator" && equipment.body?.kind === "visitor";
  const lookWhetherOver = async () => {
    const { id, patient_id: patient } = trial ?? {};
    if (!id) return;
    const trials = await app.api.get(`/trials?patient=${patient}`).catch(() => []);
    const now = trials.find((one) => one.id === id);
    if (!signal.aborted && now && now.status !== "running") app.go(`#/drive/over/${id}`);
  };
  app.live.addEventListener("changed", ({ detail }) => ["trial", "everything"].includes(detail) && lookWhetherOver(), { signal });
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
    if (!hasBegun) app.go("#/drive");
  });
}

/** @param {App} app @param {HTMLElement} root @param {string} id of the trial @param {AbortSignal} signal */
async function over(app, root, id, signal) {
  const read = await readTrial(app.api, id);
  if (signal.aborted) return;
  showTrialOver(app, root, read, (trial) => [
    adaptLink(app, trial, signal),
    h("a", { class: "btn", href: "#/drive" }, t("over.other")),
    h(
      "button",
      {
        type: "button",
        class: "btn go",
        onclick: () => app.requestTrial({ floorplan: trial.floorplan, path: trial.path_name }),
      },
      t("over.next"),
    ),
  ]);
}
