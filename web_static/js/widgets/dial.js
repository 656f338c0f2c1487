/**
 * The speed dial: which share of its speeds the chair may use. Lower at once; whether higher is possible now, the gate
 * decides.
 * @import { LiveMessage } from "../live/live.js"
 */
import { h, useRef, useSignal } from "../preact.js";
import { limitsOf } from "../reference.js";
import { t } from "../texts.js";
import { useUntilGone } from "./made.js";
import { Stepper } from "./setting.js";

const STEP = 10; // %
const ANSWERED_FOR = 400; // ms after an answer in which a live picture may still be older than it

/** @param {{app: import("../main.js").App, left: AbortSignal}} dial */
export function SpeedDial({ app, left }) {
  const shown = useSignal(share(app.live.latest)); // %
  const call = useRef({ wanted: /** @type {number | null} */ (null), answeredAt: -Infinity }); // wanted: not answered yet, %
  /** Send the newest value; while a call is under way, the next one waits. @param {number} value in % */
  const turn = async (value) => {
    const { current } = call;
    const isUnderWay = current.wanted !== null;
    shown.value = current.wanted = value;
    if (isUnderWay) return;
    await app.toasts.attempt(async () => {
      for (let sent = null; sent !== current.wanted && current.wanted !== null;) {
        sent = current.wanted;
        await app.api.post("/control/dial", { share: sent / 100 });
      }
      current.answeredAt = performance.now();
    });
    current.wanted = null;
  };
  useUntilGone(left, (signal) => {
    /** @param {CustomEvent<LiveMessage>} event */
    const follow = ({ detail: now }) => {
      const { wanted, answeredAt } = call.current;
      if (wanted === null && performance.now() - answeredAt > ANSWERED_FOR) shown.value = share(now);
    };
    app.live.addEventListener("tick", follow, { signal });
  });
  return h(Stepper, {
    label: t("dial-label"),
    value: shown.value,
    low: 100 * (limitsOf("DialShare", "share").minimum ?? 0),
    high: 100,
    step: STEP,
    digits: 0,
    unit: "%",
    onChange: turn,
  });
}

/** @param {LiveMessage | null} now @returns {number} in % */
function share(now) {
  return Math.round(100 * (now?.dial ?? 1));
}
