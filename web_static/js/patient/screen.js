/** What the patient sees: the picture, and over it the task, the speed, the arrow, and a conspicuous stop. */
import { h, put, s, set, write } from "../widgets/dom.js";
import { number } from "../widgets/format.js";
import { haltFollower, urgency } from "../shell/halt.js";
import { t } from "../texts.js";
import { arrow } from "./arrow.js";
import { cueLayer } from "./cue.js";
import { momentCard } from "./moment.js";
import { patientPicture } from "./picture.js";
import { soundsBetween, Sounds } from "./sounds.js";
import { testLayer } from "./test_layer.js";

const BACKWARDS = -0.02; // m/s

/**
 * @typedef {import("../live/live.js").PatientMessage} PatientMessage
 * @typedef {import("../live/live.js").Live<PatientMessage>} PatientLive
 */

/** @param {HTMLElement} root @param {PatientLive} live @param {AbortSignal} signal */
export function showScreen(root, live, signal) {
  const sounds = new Sounds();
  const picture = patientPicture(live, signal);
  const speed = speedCard();
  const parts = [taskCard(), speed, arrow(), momentCard(), testLayer(), cueLayer(live, signal), stopBand()];
  const lost = band("lost", h("div", {}, h("b", {}, t("patient-lost")), h("p", {}, t("patient-lost-why"))));
  const sound = h("button", { type: "button", class: "btn sound", hidden: true }, t("patient-sound"));
  sound.addEventListener("click", async () => {
    await sounds.turnOn();
    sound.hidden = sounds.isOn;
  });
  /** @type {PatientMessage | null} */
  let before = null;
  /** @param {CustomEvent<PatientMessage>} event */
  const show = ({ detail: now }) => {
    for (const part of [picture, ...parts]) part.show(now);
    document.documentElement.classList.toggle("large", now.asks.large);
    sound.hidden = !now.asks.sounds || sounds.isOn;
    if (now.asks.sounds) for (const name of soundsBetween(before, now)) sounds.play(name);
    before = now;
  };
  const showConnection = () => {
    lost.hidden = live.connected;
    root.classList.toggle("is-lost", !live.connected);
  };
  live.addEventListener("tick", show, { signal });
  live.addEventListener("connection", showConnection, { signal });
  signal.addEventListener("abort", () => root.classList.remove("is-lost")); // what the page shows next is up to date
  const others = parts.filter((part) => part !== speed);
  put(
    root,
    picture.element,
    others.map(({ element }) => element),
    h("div", { class: "corner" }, sound, speed.element),
    lost,
  );
  showConnection();
}

function taskCard() {
  const stage = h("div", { class: "stage" });
  const words = h("p", { class: "instruction", role: "status" });
  const done = h("span", {});
  const progress = h("div", { class: "progress", "aria-hidden": "true" }, done);
  const element = h("div", { class: "hud task" }, stage, words, progress);
  /** @param {PatientMessage} now */
  const show = ({ trial, state, waits }) => {
    write(stage, trial && trial.stages > 1 ? t("patient-stage", { stage: trial.stage + 1, stages: trial.stages }) : "");
    write(words, state === "disarmed" ? waits.message : (trial?.instruction ?? ""));
    progress.hidden = !trial?.length;
    if (trial?.length) done.style.width = `${100 * Math.min(1, Math.max(0, Number(trial.done) / trial.length))}%`;
    element.hidden = !words.textContent;
  };
  return { element, show };
}

function speedCard() {
  const speed = h("span", {});
  const way = h("span", { class: "way" });
  const element = h(
    "div",
    { class: "hud speed" },
    h("div", { class: "label" }, t("patient-speed")),
    h("div", { class: "big" }, speed, " ", h("small", {}, t("unit-speed"))),
    way,
  );
  /** @param {PatientMessage} now */
  const show = ({ v }) => {
    write(speed, number(Math.abs(v ?? 0), 1));
    write(way, v !== null && v < BACKWARDS ? t("patient-backwards") : "");
  };
  return { element, show };
}

/** A stop, with its reason: read out once, at once when somebody pressed Stop. */
function stopBand() {
  const element = h("div", { "aria-live": "polite" });
  const follow = haltFollower();
  let wait = h("p", {});
  let shown = "";
  /** @param {PatientMessage} now */
  const show = ({ state, fault, stops, waits }) => {
    const halt = follow(state === "fault" ? fault : null, stops);
    const key = halt?.key ?? "";
    if (key === shown) return key && write(wait, waits.message);
    shown = key;
    set(element, { "aria-live": urgency(halt) });
    wait = h("p", { class: "wait" }, waits.message);
    const words = halt && [
      h("b", {}, t("patient-stopped")),
      h("p", {}, halt.message),
      halt.again && h("p", {}, halt.again),
      wait,
    ];
    put(element, words && h("div", { class: "band stopped" }, octagon(), h("div", {}, words)));
  };
  return { element, show };
}

function octagon() {
  return s(
    "svg",
    { viewBox: "0 0 100 100", "aria-hidden": "true" },
    s("path", { class: "octagon", d: "M31 4h38l27 27v38L69 96H31L4 69V31Z" }),
    s("path", { class: "bars", d: "M36 30v40M64 30v40" }),
  );
}

/** @param {string} name class @param {...import("types/dom").Child} children */
function band(name, ...children) {
  return h("div", { class: `band ${name}`, role: "alert", hidden: true }, children);
}
