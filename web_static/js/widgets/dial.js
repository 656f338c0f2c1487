/**
 * The speed dial: which share of its speeds the chair may use. Lower at once; whether higher is possible now, the gate
 * decides.
 * @import { LiveMessage } from "../live/live.js"
 */
import { limitsOf } from "../reference.js";
import { t } from "../texts.js";
import { stepper } from "./fields.js";

const STEP = 10; // %
const ANSWERED_FOR = 400; // ms after an answer in which a live picture may still be older than it

/** @param {import("../main.js").App} app @param {AbortSignal} signal */
export function speedDial(app, signal) {
  /** @type {number | null} */
  let wanted = null; // %, while the server has not answered
  let answeredAt = -Infinity;
  const element = stepper({
    label: t("dial-label"),
    value: share(app.live.latest),
    low: 100 * (limitsOf("DialShare", "share").minimum ?? 0),
    high: 100,
    step: STEP,
    digits: 0,
    unit: "%",
    onChange: (value) => turn(value),
  });
  /** @param {CustomEvent<LiveMessage>} event */
  const follow = ({ detail: now }) => {
    if (wanted === null && performance.now() - answeredAt > ANSWERED_FOR) element.setValue(share(now));
  };
  /** Send the newest value; while a call is under way, the next one waits. @param {number} value in % */
  const turn = async (value) => {
    const isUnderWay = wanted !== null;
    wanted = value;
    if (isUnderWay) return;
    await app.toasts.attempt(async () => {
      for (let sent = null; sent !== wanted && wanted !== null;) {
        sent = wanted;
        await app.api.post("/control/dial", { share: sent / 100 });
      }
      answeredAt = performance.now();
    });
    wanted = null;
  };
  app.live.addEventListener("tick", follow, { signal });
  return element;
}

/** @param {LiveMessage | null} now @returns {number} in % */
function share(now) {
  return Math.round(100 * (now?.dial ?? 1));
}
