/**
 * The clinic's limits: what its owner allows, and clinicians move inside.
 * @import { Speeds } from "types/api"
 */
import { failureWords } from "../../api.js";
import { h, useMemo, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { facts } from "../../widgets/facts.js";
import { Made, useUntilGone } from "../../widgets/made.js";
import { SPEEDS, speedRows, speedWords } from "../../widgets/speed_rows.js";

const REST = 500; // ms without another change, then it is sent

/**
 * @param {{app: import("../../main.js").App, first: Speeds, isOwner: boolean, left: AbortSignal}} card
 *   first: what GET /limits answered
 */
export function LimitsCard({ app, first, isOwner, left }) {
  const state = useSignal("");
  const problem = useSignal("");
  const refusals = useSignal(0);
  const draft = useMemo(() => ({ limits: first, wishes: { ...first }, timer: 0 }), []);
  const send = async () => {
    draft.timer = 0;
    problem.value = "";
    try {
      draft.limits = await app.api.put("/limits", draft.wishes);
      state.value = t("limits-saved");
    } catch (error) {
      state.value = "";
      problem.value = failureWords(error);
      draft.wishes = { ...draft.limits };
      refusals.value++; // the steppers stand as before
    }
  };
  /** @param {keyof Speeds} name @param {number} value */
  const change = (name, value) => {
    draft.wishes[name] = value;
    state.value = t("limits-saving");
    clearTimeout(draft.timer);
    draft.timer = setTimeout(send, REST);
  };
  useUntilGone(left, (gone) =>
    gone.addEventListener("abort", () => {
      clearTimeout(draft.timer);
      if (draft.timer) send();
    }),
  );
  const make = () => {
    const place = document.createDocumentFragment();
    if (isOwner) place.append(...speedRows(draft.wishes, {}, change, { hasNumbers: true }).elements);
    else place.append(inWords(draft.limits));
    return place;
  };
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("limits-title"), h("span", { class: "quiet small", role: "status" }, state)),
    h("p", { class: "quiet small" }, t("limits-lead")),
    h("p", { class: "problem", role: "alert" }, problem),
    h(Made, { key: refusals.value, left, make }),
  );
}

/** @param {Speeds} clinic */
function inWords(clinic) {
  const list = facts(SPEEDS.map(({ name }) => `speed-${name}`));
  for (const speed of SPEEDS) list.write(`speed-${speed.name}`, speedWords(speed, clinic[speed.name]));
  return list.element;
}
