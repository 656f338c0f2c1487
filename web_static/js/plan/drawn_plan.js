/** The drawn plan: the floor from above around the chair, drawn by this page without WebGL. */
import { t } from "../texts.js";
import { h, set } from "../widgets/dom.js";
import { repeatWhileHeld } from "../widgets/fields.js";
import { planPicture } from "./plan_svg.js";

const STEP = 0.05; // m between two points of the driven line
const NEARER = 0.87; // ratio of the metres that are shown after and before a tap
const [NEAREST, FARTHEST, USUAL] = [4, 60, 9]; // m that are shown across the shorter side
const MIDDLE = { heading: 0.62, north: 0.5 }; // share of the height at which the chair is drawn; heading up leaves more room ahead
const PLACE = "bodydrive-drawn-plan";

/**
 * @param {any} plan @param {any} path the prescribed one
 * @returns {{element: HTMLElement, pad: HTMLElement, setShown: (is: boolean) => void,
 *   show: (now: {pose: number[], movers?: number[][], target?: number[], stage?: number}) => void, setDriven: (line: number[][]) => void}}
 *   `show` takes a moment; `setDriven` a whole trajectory, to which `show` adds nothing; `pad` turns and zooms
 */
export function drawnPlan(plan, path) {
  const picture = planPicture(plan, path.points, {
    label: t("drawn.label", { plan: plan.title, path: path.title }),
    hasRooms: true,
    asked: path,
    isTrue: true,
  });
  const element = h("div", { class: "drawn-plan" }, picture.element);
  const chosen = remembered();
  /** @type {[number, number][] | null} */
  let driven = [];
  let pose = startOf(path);

  const look = () => {
    const [x, y, theta] = pose;
    const turn = chosen.up === "heading" ? (theta * 180) / Math.PI - 90 : 0;
    picture.look({ x, y, turn, metres: chosen.metres, middle: MIDDLE[chosen.up] });
  };
  const show = (now) => {
    if (!now.pose.every(Number.isFinite)) return;
    pose = now.pose;
    picture.setPose(pose);
    if (now.movers?.length === plan.movers.length) picture.setMovers(now.movers);
    if (now.stage !== undefined) picture.setStage(now.stage);
    if (now.target) picture.setGoal(now.target);
    if (driven) addTo(driven);
    look();
  };
  const addTo = (line) => {
    const last = line.at(-1);
    if (last && Math.hypot(pose[0] - last[0], pose[1] - last[1]) < STEP) return;
    line.push([pose[0], pose[1]]);
    picture.setDriven(line);
  };
  const setDriven = (line) => {
    driven = null;
    picture.setDriven(line);
  };
  const change = (to) => {
    Object.assign(chosen, to);
    localStorage.setItem(PLACE, JSON.stringify(chosen));
    look();
  };
  const zoom = (share) => change({ metres: Math.min(FARTHEST, Math.max(NEAREST, chosen.metres * share)) });
  const pad = padOf(chosen, change, zoom);
  const setShown = (is) => {
    element.hidden = !is;
    pad.hidden = !is;
  };
  picture.setPose(pose);
  look();
  return { element, pad, show, setDriven, setShown };
}

function padOf(chosen, change, zoom) {
  const button = (name, sign, act) => {
    const words = t(`drawn.${name}`);
    const made = h("button", { type: "button", class: "btn small", "aria-label": words, title: words }, sign);
    repeatWhileHeld(made, act);
    return made;
  };
  const up = h("button", { type: "button", class: "btn small up" }, t("drawn.heading"));
  const showUp = () => set(up, { "aria-pressed": String(chosen.up === "heading") });
  up.addEventListener("click", () => {
    change({ up: chosen.up === "heading" ? "north" : "heading" });
    showUp();
  });
  showUp();
  return h(
    "div",
    { class: "hud free-pad", role: "group", "aria-label": t("drawn.group") },
    up,
    button("nearer", "+", () => zoom(NEARER)),
    button("farther", "−", () => zoom(1 / NEARER)),
  );
}

/** Where the chair is put before a trial. */
function startOf({ points: [[x, y], [nextX, nextY]], task, start_heading: heading }) {
  const along = Math.atan2(nextY - y, nextX - x);
  return [x, y, heading ?? (task.kind === "back" ? along + Math.PI : along)];
}

function remembered() {
  const usual = { up: "heading", metres: USUAL };
  try {
    const { up, metres } = JSON.parse(localStorage.getItem(PLACE) ?? "{}");
    return { up: up in MIDDLE ? up : usual.up, metres: metres >= NEAREST && metres <= FARTHEST ? metres : usual.metres };
  } catch {
    return usual;
  }
}
