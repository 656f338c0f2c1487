/**
 * The clinic's limits: what its owner allows, and clinicians move inside.
 * @import { Speeds } from "types/api"
 * @import { Fact } from "../../widgets/fact_list.js"
 */
import { failureWords } from "../../api.js";
import { h, useRef, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { FactList } from "../../widgets/fact_list.js";
import { useUntilGone } from "../../widgets/made.js";
import { SpeedRows, SPEEDS, speedWords } from "../../widgets/speed_rows.js";

const REST = 500; // ms without another change, then it is sent

/**
 * @param {{app: import("../../main.js").App, first: Speeds, isOwner: boolean, left: AbortSignal}} card
 *   first: what GET /limits answered
 */
export function LimitsCard({ app, first, isOwner, left }) {
  const limits = useRef(first); // as the server has them
  const wishes = useSignal(first);
  const state = useSignal("");
  const problem = useSignal("");
  const timer = useRef(0); // until the wishes are sent; 0: none wait
  const send = async () => {
    timer.current = 0;
    problem.value = "";
    try {
      limits.current = await app.api.put("/limits", wishes.value);
      state.value = t("limits-saved");
    } catch (error) {
      state.value = "";
      problem.value = failureWords(error);
      wishes.value = limits.current;
    }
  };
  /** @param {keyof Speeds} name @param {number} value */
  const change = (name, value) => {
    wishes.value = { ...wishes.value, [name]: value };
    state.value = t("limits-saving");
    clearTimeout(timer.current);
    timer.current = setTimeout(send, REST);
  };
  useUntilGone(left, (gone) =>
    gone.addEventListener("abort", () => {
      clearTimeout(timer.current);
      if (timer.current) send();
    }),
  );
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("limits-title"), h("span", { class: "quiet small", role: "status" }, state)),
    h("p", { class: "quiet small" }, t("limits-lead")),
    h("p", { class: "problem", role: "alert" }, problem),
    isOwner
      ? h(SpeedRows, { speeds: wishes.value, hasNumbers: true, onChange: change })
      : h(FactList, { facts: inWords(first) }),
  );
}

/** @param {Speeds} clinic @returns {Fact[]} */
function inWords(clinic) {
  return SPEEDS.map((speed) => [t(`speed-${speed.name}`), speedWords(speed, clinic[speed.name])]);
}
