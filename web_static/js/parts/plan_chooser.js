/** Cards to choose a building and a path from. */
import { t } from "../texts.js";
import { h, put } from "./dom.js";
import { number } from "./format.js";
import { planPicture } from "./plan_svg.js";

const PLACE = "bodydrive-path"; // what was chosen last on this screen
const FIRST = "clinic"; // before anything was chosen

/** @returns {{floorplan: string, path: string}} what was chosen last, as far as it still exists */
function remembered(plans) {
  const [name, path] = (localStorage.getItem(PLACE) ?? `${FIRST}/main`).split("/");
  const plan = plans.find((one) => one.name === name) ?? plans[0];
  return { floorplan: plan.name, path: (plan.paths.find((one) => one.name === path) ?? plan.paths[0]).name };
}

/**
 * @param {any[]} plans what GET /floorplans answered @param {Map<string, any>} documents floor plans by name
 */
export function planChooser(plans, documents) {
  let chosen = remembered(plans);
  const cards = plans.map((plan) => {
    const picture = h("div", { class: "plan-place" });
    const show = (path) => {
      const document = documents.get(plan.name);
      const { points, title } = document.paths.find(({ name }) => name === path);
      put(
        picture,
        planPicture(document, points, { label: t("drive.plan.label", { plan: plan.title, path: title }) }).element,
      );
    };
    const first = chosen.floorplan === plan.name ? chosen.path : plan.paths[0].name;
    const choose = (path) => {
      chosen = { floorplan: plan.name, path };
      localStorage.setItem(PLACE, `${plan.name}/${path}`);
      show(path);
      mark();
    };
    const choices = plan.paths.map((path) =>
      h(
        "label",
        { class: "choice" },
        h("input", {
          type: "radio",
          name: "path",
          value: `${plan.name}/${path.name}`,
          onchange: () => choose(path.name),
        }),
        h("b", { class: "grow" }, path.title),
        h("span", { class: "number" }, t("drive.length", { length: number(path.length, 0) })),
      ),
    );
    show(first);
    const element = h(
      "section",
      { class: "card plan-card" },
      h(
        "h2",
        {},
        plan.title,
        h(
          "span",
          { class: "quiet small" },
          t("drive.size", { width: number(plan.width, 0), height: number(plan.height, 0) }),
        ),
      ),
      picture,
      h("div", { class: "paths", role: "radiogroup", "aria-label": t("drive.paths", { plan: plan.title }) }, choices),
    );
    picture.addEventListener("click", () => choose(chosen.floorplan === plan.name ? chosen.path : first));
    return { plan, element };
  });
  const mark = () => {
    for (const { plan, element } of cards) {
      element.classList.toggle("chosen", plan.name === chosen.floorplan);
      for (const input of element.querySelectorAll("input"))
        input.checked = input.value === `${chosen.floorplan}/${chosen.path}`;
    }
  };
  mark();
  return {
    element: h(
      "div",
      { class: "plan-cards" },
      cards.map(({ element }) => element),
    ),
    chosen: () => chosen,
  };
}
