/**
 * The shirt: where the movements come from, who is inside, and how every sensor is.
 * @import { ShirtLayout } from "types/api"
 * @import { ShirtKind } from "types/documents"
 * @import { ShirtStore } from "./store.js"
 */
import { stopCamera } from "../../camera/camera.js";
import { CameraCard } from "../../camera/camera_card.js";
import { BodyCard, HeadCard, LayoutCard, SourceCard } from "./equipment_cards.js";
import { drawFoot, drawPage, Fragment, h, useLayoutEffect } from "../../preact.js";
import { jointStrips } from "../../charts/joint_strips.js";
import { jointWithin } from "../../widgets/joint_words.js";
import { BodyLamps, LampPicture, QUALITIES } from "./lamps.js";
import { Made } from "../../widgets/made.js";
import { pads } from "../../widgets/pads.js";
import { SensorCard } from "./sensor_card.js";
import { Spoken } from "./spoken.js";
import { shirtStore } from "./store.js";
import { t } from "../../texts.js";

/** @type {ShirtLayout} */
const NO_LAYOUT = { name: "", channels: [], joints: [] }; // before a shirt was chosen: a body without lamps

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal: left }) {
  const [view, kinds] = await Promise.all([app.api.get("/equipment"), app.api.get("/equipment/shirts")]);
  if (left.aborted) return;
  const store = shirtStore(app, view, /** @type {ShirtKind[]} */ (kinds), left);
  drawPage(root, h(Page, { store }));
  drawFoot(root, h(Foot, { store }));
}

/** @param {{store: ShirtStore}} page */
function Page({ store }) {
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, t("shirt-title")),
    h(State, { store }),
    h(SourceCard, { store }),
    h("div", { class: "main-columns shirt-columns" }, h(Sensors, { store }), h(Cards, { store })),
    h(Signals, { store }),
  );
}

/** @param {{store: ShirtStore}} words */
function State({ store: { live, sentence } }) {
  const { qualities, lost, arrivals } = live.value;
  const all = qualities.length;
  const good = qualities.filter((quality) => quality === "good").length;
  const isSaidBelow = arrivals?.verdict === "unopened"; // with what to do
  const figures = [all ? t("shirt-words-count", { good, all }) : "", lost ? t("shirt-lost", { count: lost }) : ""];
  return h(
    "p",
    { class: "lead" },
    !isSaidBelow && h(Spoken, { words: sentence.value }),
    " ",
    h("span", {}, figures.filter(Boolean).join(" ")),
  );
}

/** @param {{store: ShirtStore}} sensors */
function Sensors({ store: { equipment, live, moving, picked } }) {
  const layout = equipment.value.layout ?? NO_LAYOUT;
  return h(
    "div",
    { class: "stack" },
    h(
      "section",
      { class: "card" },
      h(
        "h2",
        {},
        t("shirt-sensors"),
        layout.channels.length > 0 && h("span", { class: "quiet small" }, t("shirt-sensors-hint")),
      ),
      h(BodyLamps, {
        layout,
        qualities: live.value.qualities,
        moving: moving.value,
        picked: picked.value,
        onPick: (name) => void (picked.value = name),
      }),
      h(Legend, {}),
    ),
  );
}

/** @param {{store: ShirtStore}} cards */
function Cards({ store }) {
  const { channels, joints } = store.equipment.value.layout ?? NO_LAYOUT;
  const index = channels.findIndex(({ name }) => name === store.picked.value);
  const { name = "", joint = "" } = channels[index] ?? {};
  const kind = store.equipment.value.shirt?.kind;
  useLayoutEffect(() => {
    if (kind !== "camera") stopCamera();
  }, [kind]);
  return h(
    "div",
    { class: "stack" },
    index >= 0 &&
      h(SensorCard, {
        key: `${index} ${name}`,
        store,
        name,
        index,
        joint: jointWithin(joints.find((one) => one.name === joint) ?? { name: joint, label: joint }),
      }),
    kind === "camera" && h(CameraCard, { key: "camera" }),
    h(LayoutCard, { key: "layout", store }),
    kind === "simulator" && h(BodyCard, { key: "body", store }),
    h(HeadCard, { key: "head", store }),
    h(store.ReplacedList, { key: "replaced" }),
  );
}

/** @param {{store: ShirtStore}} signals */
function Signals({ store: { app, left, equipment } }) {
  const { body, layout } = equipment.value;
  return h(
    "div",
    {},
    body?.kind === "visitor" &&
      h(Made, { key: "pads", class: "card pad-card", left, make: (gone) => pads(app, gone).element }),
    layout &&
      h(
        "section",
        { class: "card", key: traceKey(layout) },
        h("h2", {}, t("traces-title")),
        h(Made, { left, make: (gone) => jointStrips(app.live, layout, gone) }),
      ),
  );
}

/** What the traces are drawn by: with others, they begin anew. @param {ShirtLayout} layout */
function traceKey({ channels, joints }) {
  return [...joints.map(({ name }) => name), ...channels.map(({ name, joint }) => `${name} ${joint}`)].join();
}

/** @param {{store: ShirtStore}} foot */
function Foot({ store: { equipment, live } }) {
  const { isSending, session } = live.value;
  const step = session?.has_profile && session.obstacle?.page !== "calibrate" ? "drive" : "calibrate";
  const isHidden = !equipment.value.shirt || !isSending; // first a shirt that sends
  return h(
    Fragment,
    {},
    h("span", { class: "grow" }),
    h("a", { class: "btn go", href: `#/${step}`, hidden: isHidden }, t(`shirt-${step}`)),
  );
}

function Legend() {
  return h(
    "details",
    { class: "lamp-legend" },
    h("summary", {}, t("shirt-legend")),
    h(
      "dl",
      {},
      Object.keys(QUALITIES).map((quality) =>
        h(
          Fragment,
          { key: quality },
          h("dt", {}, h(LampPicture, { quality, size: 22 }), t(`quality-${quality}`)),
          h("dd", {}, t(`quality-${quality}-words`)),
        ),
      ),
    ),
  );
}
