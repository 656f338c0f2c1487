/**
 * All tasks in groups: a tap shows the places of one group, another one leads to the Drive page with the task.
 * @import { FloorPlanView } from "types/api"
 * @import { Task } from "./task_words.js"
 */
import { t } from "../../texts.js";
import { h, put, set } from "../../widgets/dom.js";
import { segments } from "../../widgets/fields.js";
import { number } from "../../widgets/format.js";
import { planPicture } from "../../plan/plan_svg.js";
import { findTask, pathWords, taskLink } from "./task_words.js";

const GROUPS = /** @type {const} */ (["first", "corridors", "doors", "obstacles", "following", "outdoors", "own"]);

/**
 * @param {import("../../main.js").App} app @param {HTMLElement} root
 * @param {string[]} named floor plan and path of the task that the Drive page shows @param {AbortSignal} signal
 */
export async function showChooser(app, root, [floorplan, path], signal) {
  const plans = await app.api.get("/floorplans");
  if (signal.aborted) return;
  const current = findTask(plans, floorplan, path);
  const title = h("h2", { class: "unseen" });
  const about = h("p", { class: "quiet small" });
  const cards = h("div", { class: "plan-cards" });
  const buttons = GROUPS.map((group) =>
    h("button", { type: "button", class: "btn", onclick: () => choose(group) }, t(`drive-group-${group}`)),
  );
  /** @param {typeof GROUPS[number]} group */
  const choose = (group) => {
    buttons.forEach((button, i) => set(button, { "aria-pressed": String(GROUPS[i] === group) }));
    const found = places(plans.filter((plan) => plan.group === group));
    put(title, t(`drive-group-${group}`));
    put(
      about,
      group === "own" && !found.length && [t("drive-own-none"), " "],
      group === "own" &&
        app.me?.role !== "reviewer" &&
        h("a", { class: "btn small", href: "#/plans" }, t("drive-own-go")),
    );
    put(
      cards,
      found.map((levels) => placeCard(app, levels, current, signal)),
    );
  };
  choose(current?.plan.group ?? "first");
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("drive-choose-title")),
      h("p", { class: "lead" }, t("drive-choose-lead")),
      h("div", { class: "task-groups", role: "group", "aria-label": t("drive-choose-groups") }, buttons),
      title,
      about,
      cards,
    ),
    h(
      "div",
      { class: "foot" },
      h("span", { class: "grow" }),
      h("a", { class: "btn", href: current ? taskLink("task", current) : "#/drive" }, t("back")),
    ),
  );
}

/** The plans that are levels of one scene together, after the buildings. @param {FloorPlanView[]} plans */
function places(plans) {
  /** @type {Map<string, FloorPlanView[]>} */
  const found = new Map();
  for (const plan of plans) {
    const key = plan.scene ? `scene ${plan.scene.name}` : plan.name;
    found.set(key, [...(found.get(key) ?? []), plan]);
  }
  return [...found.values()].sort(([one], [other]) => Number(Boolean(one.scene)) - Number(Boolean(other.scene)));
}

/**
 * @param {import("../../main.js").App} app @param {FloorPlanView[]} levels of one scene, or one building
 * @param {Task | undefined} current @param {AbortSignal} signal
 */
function placeCard(app, levels, current, signal) {
  const { scene, title: planTitle, width, height } = levels[0];
  const title = scene?.title ?? planTitle;
  const picture = h("div", { class: "plan-place" });
  const tasks = h("ul", { class: "paths" });
  /** @param {FloorPlanView} plan @param {FloorPlanView["paths"][number]} path */
  const taskItem = (plan, path) => {
    const isCurrent = plan.name === current?.plan.name && path.name === current.path.name;
    return h(
      "li",
      {},
      h(
        "a",
        { class: "choice", href: taskLink("task", { plan, path }), "aria-current": isCurrent ? "true" : null },
        h("b", { class: "grow" }, path.title),
        h("span", { class: "number" }, pathWords(path)),
      ),
    );
  };
  /** @param {FloorPlanView} plan */
  const setLevel = async (plan) => {
    put(
      tasks,
      plan.paths.map((path) => taskItem(plan, path)),
    );
    const document = await app.api.get(`/floorplans/${plan.name}`).catch(() => null);
    if (
      signal.aborted ||
      !document ||
      !tasks.querySelector(`[href^="${taskLink("task", { plan, path: plan.paths[0] })}"]`)
    )
      return;
    const [request] = document.paths;
    const label = t("drive-plan-label", { plan: plan.title, path: request.title });
    put(picture, planPicture(document, request.points, { label, request }).element);
  };
  const first = levels.find(({ name }) => name === current?.plan.name) ?? levels[0];
  setLevel(first);
  return h(
    "section",
    { class: "card plan-card" },
    h(
      "h3",
      {},
      title,
      !scene &&
        h("span", { class: "quiet small" }, t("drive-size", { width: number(width, 0), height: number(height, 0) })),
    ),
    scene && h("p", { class: "quiet small about" }, scene.about),
    picture,
    h(
      "div",
      { class: "stack" },
      levels.length > 1 &&
        segments(
          t("drive-level", { plan: title }),
          levels.map(({ name, level, title: own }) => ({ value: name, label: level?.title ?? own })),
          first.name,
          (name) => setLevel(levels.find((one) => one.name === name) ?? first),
        ),
      tasks,
    ),
  );
}
