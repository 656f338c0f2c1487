/**
 * An arrow on the screen that points from the chair to the target.
 * @import { PatientMessage } from "../live/live.js"
 */
import { h, useComputed } from "../preact.js";
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

/** Where the target is, null while no arrow shows it. @param {PatientMessage | null} now */
function targetNow(now) {
  const target = now?.asks.arrow ? now.trial?.target : null;
  if (!now || !target || !isPose(now.pose)) return null;
  const { bearing, distance } = bearingTo(now.pose, target);
  return { bearing: distance < NEAR ? 0 : bearing, distance };
}

/** @param {import("./screen.js").Newest} arrow */
export function Arrow({ now }) {
  const target = useComputed(() => targetNow(now.value));
  const isHidden = useComputed(() => !target.value);
  const turn = useComputed(() => {
    const { bearing } = target.value ?? { bearing: 0 };
    return `rotate(${Math.round((-bearing * 180) / Math.PI)} 50 50)`;
  });
  const where = useComputed(() => {
    const { bearing } = target.value ?? { bearing: 0 };
    return t("patient-arrow", { where: t(`patient-arrow-${side(bearing)}`) });
  });
  const distance = useComputed(
    () => target.value && t("patient-arrow-distance", { distance: number(target.value.distance, 1) }),
  );
  return h(
    "div",
    { class: "hud arrow", hidden: isHidden },
    h("span", { class: "label" }, t("patient-goal-name")),
    h(
      "svg",
      { viewBox: "0 0 100 100", role: "img", "aria-label": where },
      h("path", { d: "M50 8 82 88 50 70 18 88Z", transform: turn }),
    ),
    h("span", { class: "number" }, distance),
  );
}
