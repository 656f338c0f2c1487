/**
 * The clinic's limits: what its owner allows, and clinicians move inside.
 * @import { Speeds } from "types/api"
 */
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, put, write } from "../../widgets/dom.js";
import { facts } from "../../widgets/facts.js";
import { SPEEDS, speedRows, speedWords } from "../../widgets/speed_rows.js";

const REST = 500; // ms without another change, then it is sent

/** @param {import("../../main.js").App} app @param {Speeds} clinic what GET /limits answered @param {boolean} isOwner @param {AbortSignal} signal */
export function limitsCard(app, clinic, isOwner, signal) {
  const state = h("span", { class: "quiet small", role: "status" });
  const problem = h("p", { class: "problem", role: "alert" });
  const place = h("div", {});
  let limits = clinic;
  let wishes = { ...clinic };
  let timer = 0;
  const draw = () =>
    put(place, isOwner ? speedRows(wishes, {}, change, { hasNumbers: true }).elements : inWords(limits));
  /** @param {keyof Speeds} name @param {number} value */
  const change = (name, value) => {
    wishes[name] = value;
    write(state, t("limits-saving"));
    clearTimeout(timer);
    timer = setTimeout(send, REST);
  };
  const send = async () => {
    timer = 0;
    write(problem, "");
    try {
      limits = await app.api.put("/limits", wishes);
      write(state, t("limits-saved"));
    } catch (error) {
      write(state, "");
      write(problem, failureWords(error));
      wishes = { ...limits };
      draw();
    }
  };
  signal.addEventListener("abort", () => {
    clearTimeout(timer);
    if (timer) send();
  });
  draw();
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("limits-title"), state),
    h("p", { class: "quiet small" }, t("limits-lead")),
    problem,
    place,
  );
}

/** @param {Speeds} clinic */
function inWords(clinic) {
  const list = facts(SPEEDS.map(({ name }) => `speed-${name}`));
  for (const speed of SPEEDS) list.write(`speed-${speed.name}`, speedWords(speed, clinic[speed.name]));
  return list.element;
}
