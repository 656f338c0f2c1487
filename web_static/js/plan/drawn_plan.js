/** The drawn plan: the floor around the chair from above, drawn by this page without WebGL. */
import { t } from "../texts.js";
import { h, set } from "../widgets/dom.js";
import { repeatWhileHeld } from "../widgets/held_button.js";
import { isPose } from "./floor_plan.js";
import { planPicture } from "./plan_svg.js";

const STEP = 0.05; // m between two points of the trajectory
const NEARER = 0.87; // ratio of the metres that are shown after a tap to those before it
const [NEAREST, FARTHEST, USUAL] = [4, 60, 9]; // m that are shown across the shorter side
const MIDDLE = { heading: 0.62, north: 0.5 }; // share of the height at which the chair is drawn; heading up leaves more room ahead
const STORAGE_KEY = "bodydrive-drawn-plan";

/**
 * @typedef {import("./floor_plan.js").Point} Point
 * @typedef {import("./floor_plan.js").PrescribedPath} PrescribedPath
 * @typedef {{up: keyof typeof MIDDLE, metres: number}} Settings which direction is up; m shown across the shorter side
 * @typedef {{pose: (number | null)[], movers?: (number | null)[][], target?: number[], stage?: number}} PlanMoment
 */

/**
 * @param {import("./floor_plan.js").FloorPlan} plan @param {PrescribedPath} path
 * @returns {{element: HTMLElement, pad: HTMLElement, setShown: (is: boolean) => void,
 *   show: (now: PlanMoment) => void, setTrajectory: (line: Point[]) => void}}
 *   `show` draws a moment and adds its place to the trajectory; `setTrajectory` draws a whole trajectory, to which `show`
 *   adds nothing; `pad` holds the buttons that turn and zoom
 */
export function drawnPlan(plan, path) {
  const picture = planPicture(plan, path.points, {
    label: t("drawn-label", { plan: plan.title, path: path.title }),
    hasRooms: true,
    request: path,
    isTrue: true,
  });
  const element = h("div", { class: "drawn-plan" }, picture.element);
  const settings = storedSettings();
  /** @type {Point[] | null} */
  let trajectory = [];
  /** @type {import("./floor_plan.js").Pose} */
  let pose = startOf(path);

  const look = () => {
    const [x, y, theta] = pose;
    const turn = settings.up === "heading" ? (theta * 180) / Math.PI - 90 : 0;
    picture.look({ x, y, turn, metres: settings.metres, middle: MIDDLE[settings.up] });
  };
  /** @param {PlanMoment} now */
  const show = (now) => {
    if (!isPose(now.pose)) return;
    pose = now.pose;
    picture.setPose(pose);
    if (now.movers?.length === plan.movers.length) picture.setMovers(now.movers);
    if (now.stage !== undefined) picture.setStage(now.stage);
    if (now.target) picture.setGoal(now.target);
    if (trajectory) addTo(trajectory);
    look();
  };
  /** @param {Point[]} line */
  const addTo = (line) => {
    const last = line.at(-1);
    if (last && Math.hypot(pose[0] - last[0], pose[1] - last[1]) < STEP) return;
    line.push([pose[0], pose[1]]);
    picture.setTrajectory(line);
  };
  /** @param {Point[]} line */
  const setTrajectory = (line) => {
    trajectory = null;
    picture.setTrajectory(line);
  };
  /** @param {Partial<Settings>} change */
  const choose = (change) => {
    Object.assign(settings, change);
    localStorage.setItem(STORAGE_KEY, JSON.stringify(settings));
    look();
  };
  /** @param {number} ratio of the metres shown */
  const zoom = (ratio) => choose({ metres: Math.min(FARTHEST, Math.max(NEAREST, settings.metres * ratio)) });
  const pad = padOf(settings, choose, zoom);
  /** @param {boolean} is */
  const setShown = (is) => {
    element.hidden = !is;
    pad.hidden = !is;
  };
  picture.setPose(pose);
  look();
  return { element, pad, show, setTrajectory, setShown };
}

/** @param {Settings} settings @param {(change: Partial<Settings>) => void} choose @param {(ratio: number) => void} zoom */
function padOf(settings, choose, zoom) {
  /** @param {"nearer" | "farther"} name @param {string} sign @param {() => void} act */
  const button = (name, sign, act) => {
    const words = t(`drawn-${name}`);
    const made = h("button", { type: "button", class: "btn small", "aria-label": words, title: words }, sign);
    repeatWhileHeld(made, act);
    return made;
  };
  const up = h("button", { type: "button", class: "btn small up" }, t("drawn-heading"));
  const showUp = () => set(up, { "aria-pressed": String(settings.up === "heading") });
  up.addEventListener("click", () => {
    choose({ up: settings.up === "heading" ? "north" : "heading" });
    showUp();
  });
  showUp();
  return h(
    "div",
    { class: "hud free-pad", role: "group", "aria-label": t("drawn-group") },
    up,
    button("nearer", "+", () => zoom(NEARER)),
    button("farther", "−", () => zoom(1 / NEARER)),
  );
}

/** The pose of the chair before a trial. @param {PrescribedPath} path @returns {import("./floor_plan.js").Pose} */
function startOf({ points: [[x, y], [nextX, nextY]], task, start_heading: startHeading }) {
  const along = Math.atan2(nextY - y, nextX - x);
  return [x, y, startHeading ?? (task.kind === "back" ? along + Math.PI : along)];
}

/** @returns {Settings} */
function storedSettings() {
  /** @type {Settings} */
  const usual = { up: "heading", metres: USUAL };
  try {
    const { up, metres } = JSON.parse(localStorage.getItem(STORAGE_KEY) ?? "{}");
    return {
      up: up in MIDDLE ? up : usual.up,
      metres: metres >= NEAREST && metres <= FARTHEST ? metres : usual.metres,
    };
  } catch {
    return usual;
  }
}
