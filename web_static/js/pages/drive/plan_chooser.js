/**
 * Cards to choose where to drive: scenes with their levels and tasks, then buildings with their paths.
 * @import { FloorPlan, FloorPlanView, PathView } from "types/api"
 * @import { Child } from "types/dom"
 * @typedef {{floorplan: string, path: string}} Place
 * @typedef {(name: string) => Promise<FloorPlan>} ReadPlan
 */
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { segments } from "../../widgets/fields.js";
import { number } from "../../widgets/format.js";
import { planPicture } from "../../plan/plan_svg.js";

const PLACE = "bodydrive-path"; // what was chosen last on this screen
const FIRST = "clinic"; // before anything was chosen

/** What was chosen last, as far as it still exists. @param {FloorPlanView[]} plans @returns {Place} */
function lastChoice(plans) {
  const [name, path] = (localStorage.getItem(PLACE) ?? `${FIRST}/main`).split("/");
  const plan = plans.find((one) => one.name === name) ?? plans[0];
  return { floorplan: plan.name, path: (plan.paths.find((one) => one.name === path) ?? plan.paths[0]).name };
}

/** The plans that are levels of one scene together; a building by itself. @param {FloorPlanView[]} plans */
function places(plans) {
  /** @type {Map<string, FloorPlanView[]>} */
  const groups = new Map();
  for (const plan of plans) {
    const key = plan.scene ? `scene ${plan.scene.name}` : plan.name;
    groups.set(key, [...(groups.get(key) ?? []), plan]);
  }
  return [...groups.values()];
}

/**
 * @param {FloorPlanView[]} plans what GET /floorplans answered @param {ReadPlan} read a floor plan's document
 * @param {(words: string) => void} onChosen called with the choice in words
 */
export function planChooser(plans, read, onChosen) {
  let chosen = lastChoice(plans);
  /** @param {string} floorplan @param {string} path */
  const remember = (floorplan, path) => {
    chosen = { floorplan, path };
    localStorage.setItem(PLACE, `${floorplan}/${path}`);
    mark();
  };
  const mark = () => {
    for (const card of cards) card.mark(chosen);
    const plan = plans.find(({ name }) => name === chosen.floorplan);
    onChosen(`${plan?.title}: ${plan?.paths.find(({ name }) => name === chosen.path)?.title}`);
  };
  const cards = places(plans).map((levels) => placeCard(levels, chosen, read, remember));
  mark();
  const scenes = cards.filter(({ isScene }) => isScene);
  const buildings = cards.filter(({ isScene }) => !isScene);
  /** @param {string} title @param {typeof cards} some */
  const group = (title, some) =>
    some.length > 0 && [
      h("h2", { class: "group-title" }, t(title)),
      h("div", { class: "plan-cards" }, some.map(({ element }) => element)),
    ];
  return {
    element: h("div", { class: "stack" }, group("drive.scenes", scenes), group("drive.buildings", buildings)),
    chosen: () => chosen,
    show: () => cards.find(({ has }) => has(chosen.floorplan))?.element.scrollIntoView({ block: "center" }),
  };
}

/**
 * @param {FloorPlanView[]} levels of one scene, or one building @param {Place} chosen @param {ReadPlan} read
 * @param {(floorplan: string, path: string) => void} remember
 */
function placeCard(levels, chosen, read, remember) {
  let plan = levels.find(({ name }) => name === chosen.floorplan) ?? levels[0];
  let path = plan.name === chosen.floorplan ? chosen.path : plan.paths[0].name;
  const { scene } = plan;
  const title = scene?.title ?? plan.title;
  const picture = h("div", { class: "plan-place" });
  const place = h("div", { class: "paths", role: "radiogroup", "aria-label": t("drive.paths", { plan: title }) });
  const show = async () => {
    const wanted = plan.name;
    const document = await read(wanted).catch(() => null);
    if (wanted !== plan.name || !document) return;
    const task = document.paths.find(({ name }) => name === path) ?? document.paths[0];
    const label = t("drive.plan.label", { plan: plan.title, path: task.title });
    put(picture, planPicture(document, task.points, { label, request: task }).element);
  };
  /** @param {string} name of a path */
  const choose = (name) => {
    path = name;
    remember(plan.name, path);
    show();
  };
  const list = () => put(place, plan.paths.map((one) => taskChoice(plan, one, () => choose(one.name))));
  /** @param {string} name of a plan */
  const setLevel = (name) => {
    plan = levels.find((one) => one.name === name) ?? plan;
    list();
    choose(plan.paths.some((one) => one.name === path) ? path : plan.paths[0].name);
  };
  const element = h(
    "section",
    { class: "card plan-card" },
    h(
      "h3",
      {},
      title,
      !scene && h("span", { class: "quiet small" }, t("drive.size", { width: number(plan.width, 0), height: number(plan.height, 0) })),
    ),
    scene && h("p", { class: "quiet small about" }, scene.about),
    picture,
    h(
      "div",
      { class: "stack" },
      levels.length > 1 &&
        segments(t("drive.level", { plan: title }), levels.map((one) => ({ value: one.name, label: one.level?.title ?? one.title })), plan.name, setLevel),
      place,
    ),
  );
  picture.addEventListener("click", () => choose(path));
  list();
  show();
  /** @param {Place} place */
  const mark = ({ floorplan, path: name }) => {
    element.classList.toggle("chosen", levels.some((one) => one.name === floorplan));
    for (const input of place.querySelectorAll("input")) input.checked = input.value === `${floorplan}/${name}`;
  };
  /** @param {string} name of a plan */
  const has = (name) => levels.some((one) => one.name === name);
  return { element, mark, has, isScene: Boolean(scene) };
}

/** @param {FloorPlanView} plan @param {PathView} path @param {() => void} onChoose */
function taskChoice(plan, path, onChoose) {
  const length = path.task === "turn" || path.task === "course" ? "" : t("drive.length", { length: number(path.length, 0) });
  return h(
    "label",
    { class: "choice" },
    h("input", { type: "radio", name: "path", value: `${plan.name}/${path.name}`, onchange: onChoose }),
    h("b", { class: "grow" }, path.title),
    h("span", { class: "number" }, path.task === "path" ? length : [t(`task.${path.task}`), length && ` · ${length}`]),
  );
}
