/** An arrow on the screen that points from the chair to the target. */
import { h, s, set, write } from "../widgets/dom.js";
import { isPose } from "../plan/floor_plan.js";
import { number } from "../widgets/format.js";
import { t } from "../texts.js";

const NEAR = 0.2; // m: at a shorter distance the direction has no meaning
const AHEAD = Math.PI / 6; // rad to either side
const BEHIND = (5 * Math.PI) / 6; // rad

/**
 * The bearing and the distance of a target, as seen from the chair.
 * @param {import("../plan/floor_plan.js").Pose} pose @param {readonly number[]} target x, y in m
 * @returns {{bearing: number, distance: number}} rad, left positive, within a half turn; m
 */
export function bearingTo([x, y, theta], [targetX, targetY]) {
  const [dx, dy] = [targetX - x, targetY - y];
  const bearing = Math.atan2(dy, dx) - theta;
  return { bearing: Math.atan2(Math.sin(bearing), Math.cos(bearing)), distance: Math.hypot(dx, dy) };
}

/** @param {number} bearing rad, left positive @returns {"ahead" | "left" | "right" | "behind"} */
export function side(bearing) {
  if (Math.abs(bearing) <= AHEAD) return "ahead";
  if (Math.abs(bearing) >= BEHIND) return "behind";
  return bearing > 0 ? "left" : "right";
}

export function arrow() {
  const needle = s("path", { d: "M50 8 82 88 50 70 18 88Z" });
  const distance = h("span", { class: "number" });
  const picture = s("svg", { viewBox: "0 0 100 100", role: "img" }, needle);
  const element = h(
    "div",
    { class: "hud arrow", hidden: true },
    h("span", { class: "label" }, t("patient-goal-name")),
    picture,
    distance,
  );
  /** @param {import("../live/live.js").PatientMessage} now */
  const show = ({ asks, trial, pose }) => {
    const target = asks.arrow && isPose(pose) ? trial?.target : null;
    element.hidden = !target;
    if (!target || !isPose(pose)) return;
    const to = bearingTo(pose, target);
    const bearing = to.distance < NEAR ? 0 : to.bearing;
    set(needle, { transform: `rotate(${Math.round((-bearing * 180) / Math.PI)} 50 50)` });
    set(picture, { "aria-label": t("patient-arrow", { where: t(`patient-arrow-${side(bearing)}`) }) });
    write(distance, t("patient-arrow-distance", { distance: number(to.distance, 1) }));
  };
  return { element, show };
}
