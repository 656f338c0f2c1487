/** The quality lamps on the body: every state differs by colour, by shape and by sign; the nearest lamp is the one that is tapped. */
import { t } from "../../texts.js";
import { HEIGHT, LAYOUT_HEIGHT, outline, WIDTH } from "./body_outline.js";
import { h, s, set } from "../../widgets/dom.js";
import { labelsOf, sensorName } from "../../widgets/joint_words.js";
import { lampPlaces, spread } from "./lamp_places.js";

const SIZE = 8.7; // half the width of a lamp, in units of the outline: 24 px on a figure of 280 px
/** The view box of a picture of one lamp. */
export const LAMP_BOX = "-12 -12 24 24";
const APART = 17.8; // between the middles of two lamps, at least
/** @type {Record<string, SVGElement>} */
const SHAPES = {
  circle: s("circle", { r: SIZE }),
  diamond: s("path", { d: `M0 ${-SIZE * 1.3}L${SIZE * 1.3} 0 0 ${SIZE * 1.3} ${-SIZE * 1.3} 0Z` }),
  square: s("rect", { x: -SIZE, y: -SIZE, width: 2 * SIZE, height: 2 * SIZE, rx: 1 }),
  triangle: s("path", { d: `M0 ${-SIZE * 1.25}L${SIZE * 1.3} ${SIZE} ${-SIZE * 1.3} ${SIZE}Z` }),
};
/** @type {Record<string, {shape: string, sign: string}>} */
export const QUALITIES = {
  good: { shape: "circle", sign: "" },
  near: { shape: "diamond", sign: "!" },
  railed: { shape: "square", sign: "R" },
  flat: { shape: "square", sign: "–" },
  noisy: { shape: "triangle", sign: "~" },
  nan: { shape: "square", sign: "×" },
  estimated: { shape: "triangle", sign: "≈" },
  unused: { shape: "circle", sign: "/" },
  silent: { shape: "circle", sign: "?" },
};

const SIDES = /** @type {const} */ (["front", "back"]);
/** What a key moves the choice by. @type {Record<string, number | undefined>} */
const STEPS = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };

/**
 * @typedef {import("./lamp_places.js").Channel} Channel
 * @typedef {ReturnType<typeof makeLamp>} Lamp
 */

/** The sign of one quality, as it stands on the body and in the legend. @param {string} quality */
export function lampSign(quality) {
  const { shape, sign } = QUALITIES[quality] ?? QUALITIES.silent;
  return [SHAPES[shape].cloneNode(true), s("text", { y: 3.9, "text-anchor": "middle" }, sign)];
}

/**
 * Both sides of the body with a lamp for every channel.
 * @param {{channels: Channel[], joints: {name: string, label: string}[]}} layout
 * @param {(name: string) => void} onPick
 */
export function bodyLamps(layout, onPick) {
  const labels = labelsOf(layout.joints);
  const places = lampPlaces(layout.channels).map((place) => ({ ...place, at: inDrawing(place.position) }));
  for (const side of SIDES)
    spread(
      places.filter((place) => place.side === side).map(({ at }) => at),
      APART,
      [WIDTH, HEIGHT],
    );
  const lamps = places.map(makeLamp);
  let picked = "";
  /** @param {Lamp} lamp @param {boolean} focus */
  const pick = (lamp, focus) => {
    onPick(lamp.channel.name);
    if (focus) lamp.element.focus();
  };
  const sides = SIDES.map((side) => {
    const here = lamps.filter((lamp) => lamp.side === side);
    const group = s("g", {});
    for (const lamp of here) {
      lamp.element.addEventListener("keydown", (event) => {
        const step = STEPS[event.key];
        if (!step && event.key !== " " && event.key !== "Enter") return;
        event.preventDefault();
        pick(lamps[(lamps.indexOf(lamp) + (step ?? 0) + lamps.length) % lamps.length], true);
      });
      group.append(lamp.element);
    }
    const picture = s("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}` }, outline(side), group);
    picture.addEventListener("click", (event) => {
      const nearest = nearestLamp(picture, here, event);
      if (nearest) pick(nearest, false);
    });
    return h("figure", {}, picture, h("figcaption", {}, t(`shirt-${side}`)));
  });
  if (lamps.length) set(lamps[0].element, { tabindex: "0" });

  /** @param {string[]} qualities */
  const show = (qualities) => {
    for (const lamp of lamps) {
      const quality = qualities[lamp.index] ?? "silent";
      if (quality === lamp.quality) continue;
      lamp.quality = quality;
      lamp.element.replaceChildren(...lampSign(quality));
      set(lamp.element, {
        "data-quality": quality,
        "aria-label": `${sensorName(lamp.channel.name)}, ${labels[lamp.channel.joint]}: ${t(`quality-${quality}`)}`,
      });
    }
  };
  /** @param {string} name of the sensor that was picked */
  const mark = (name) => {
    picked = name;
    for (const lamp of lamps) {
      const is = lamp.channel.name === picked;
      set(lamp.element, { "aria-checked": is, tabindex: is || (!picked && lamp === lamps[0]) ? "0" : "-1" });
    }
  };
  show([]);
  return {
    element: h("div", { class: "bodies", role: "radiogroup", "aria-label": t("shirt-sensors-label") }, sides),
    show,
    mark,
  };
}

/** A lamp without a quality yet. @param {ReturnType<typeof lampPlaces>[number] & {at: [number, number]}} place */
function makeLamp(place) {
  const [x, y] = place.at;
  const element = s("g", {
    class: "sensor",
    transform: `translate(${x} ${y})`,
    role: "radio",
    "aria-checked": "false",
    tabindex: "-1",
  });
  return { ...place, quality: "", element };
}

/** @param {[number, number]} position of a layout @returns {[number, number]} in units of the outline */
function inDrawing(position) {
  return [position[0] * WIDTH, position[1] * LAYOUT_HEIGHT];
}

/** @param {SVGGraphicsElement} picture @param {Lamp[]} lamps @param {MouseEvent} event @returns {Lamp | null} */
function nearestLamp(picture, lamps, event) {
  const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(picture.getScreenCTM()?.inverse());
  /** @param {Lamp} lamp */
  const distance = (lamp) => {
    return Math.hypot(lamp.at[0] - at.x, lamp.at[1] - at.y);
  };
  const [first = null, ...others] = lamps;
  return others.reduce((best, lamp) => (best && distance(lamp) < distance(best) ? lamp : best), first);
}
