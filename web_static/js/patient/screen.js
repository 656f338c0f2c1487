/**
 * What the patient sees: the picture, and over it the task, the speed, the arrow, and a conspicuous stop.
 * @import { PatientMessage } from "../live/live.js"
 * @import { ReadonlySignal } from "../preact.js"
 * @import { ScreenStore } from "./store.js"
 * @typedef {{now: ReadonlySignal<PatientMessage | null>}} Newest the newest message, of twenty a second: what is drawn
 *   follows computed signals, which change only when what is shown does
 */
import { Fragment, h, useComputed, useLayoutEffect, useRef } from "../preact.js";
import { number } from "../widgets/format.js";
import { urgency } from "../shell/halt.js";
import { t } from "../texts.js";
import { Arrow } from "./arrow.js";
import { CameraButton } from "./camera_button.js";
import { CueLayer } from "./cue.js";
import { Moment } from "./moment.js";
import { patientPicture } from "./picture.js";
import { TestLayer } from "./test_layer.js";

const BACKWARDS = -0.02; // m/s

/** @param {{store: ScreenStore}} screen */
export function Screen({ store }) {
  const { live, now, moment, isConnected } = store;
  return h(
    Fragment,
    {},
    h(Picture, { store }),
    h(Task, { now }),
    h(Arrow, { now }),
    h(Moment, { moment }),
    h(TestLayer, { now }),
    h(CueLayer, { live, now }),
    h(StopBand, { store }),
    h("div", { class: "corner" }, h(CameraButton, { now }), h(SoundButton, { store }), h(Speed, { now })),
    h(
      "div",
      { class: "band lost", role: "alert", hidden: isConnected },
      h("div", {}, h("b", {}, t("patient-lost")), h("p", {}, t("patient-lost-why"))),
    ),
  );
}

/**
 * The place of the picture, which is made by hand: it changes in the moment in which the server is told.
 * @param {{store: ScreenStore}} picture
 */
function Picture({ store: { live, left } }) {
  const place = useRef(/** @type {HTMLDivElement | null} */ (null));
  useLayoutEffect(() => place.current?.append(...patientPicture(live, left)), []);
  return h("div", { class: "picture-place", ref: place });
}

/** @param {Newest} task */
function Task({ now }) {
  const stage = useComputed(() => {
    const trial = now.value?.trial;
    return trial && trial.stages > 1 ? t("patient-stage", { stage: trial.stage + 1, stages: trial.stages }) : "";
  });
  const words = useComputed(() => {
    if (now.value?.state === "disarmed") return now.value.waits.message;
    return now.value?.trial?.instruction ?? "";
  });
  return h(
    "div",
    { class: "hud task", hidden: !words.value },
    h("div", { class: "stage" }, stage),
    h("p", { class: "instruction", role: "status" }, words),
    h(Progress, { now }),
  );
}

/** @param {Newest} bar */
function Progress({ now }) {
  const percent = useComputed(() => {
    const trial = now.value?.trial;
    return trial?.length ? 100 * Math.min(1, Math.max(0, Number(trial.done) / trial.length)) : null;
  }).value;
  return h(
    "div",
    { class: "progress", "aria-hidden": "true", hidden: percent === null },
    h("span", { style: { width: `${percent ?? 0}%` } }),
  );
}

/** @param {Newest} card */
function Speed({ now }) {
  const speed = useComputed(() => (now.value ? number(Math.abs(now.value.v ?? 0), 1) : ""));
  const way = useComputed(() => ((now.value?.v ?? 0) < BACKWARDS ? t("patient-backwards") : ""));
  return h(
    "div",
    { class: "hud speed" },
    h("div", { class: "label" }, t("patient-speed")),
    h("div", { class: "big" }, h("span", {}, speed), " ", h("small", {}, t("unit-speed"))),
    h("span", { class: "way" }, way),
  );
}

/** @param {{store: ScreenStore}} button */
function SoundButton({ store: { isMute, turnSoundOn } }) {
  return h(
    "button",
    { type: "button", class: "btn sound", hidden: !isMute.value, onClick: turnSoundOn },
    t("patient-sound"),
  );
}

/** A stop, with its reason: read out once, at once when somebody pressed Stop. @param {{store: ScreenStore}} band */
function StopBand({ store: { now, halt } }) {
  const waits = useComputed(() => now.value?.waits.message ?? "");
  const shown = halt.value;
  return h(
    "div",
    { "aria-live": urgency(shown) },
    shown &&
      h(
        "div",
        { key: shown.key, class: "band stopped" },
        h(Octagon, {}),
        h(
          "div",
          {},
          h("b", {}, t("patient-stopped")),
          h("p", {}, shown.message),
          shown.again && h("p", {}, shown.again),
          h("p", { class: "wait" }, waits),
        ),
      ),
  );
}

function Octagon() {
  return h(
    "svg",
    { viewBox: "0 0 100 100", "aria-hidden": "true" },
    h("path", { class: "octagon", d: "M31 4h38l27 27v38L69 96H31L4 69V31Z" }),
    h("path", { class: "bars", d: "M36 30v40M64 30v40" }),
  );
}
