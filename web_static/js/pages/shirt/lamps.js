/** The quality lamps on the body: every state differs by colour, by shape and by sign; the nearest lamp is the one that is tapped. */
import { Fragment, h, useMemo, useRef } from "../../preact.js";
import { t } from "../../texts.js";
import { HEIGHT, inDrawing, Outline, pointIn, SIDES, WIDTH } from "./body_outline.js";
import { labelsOf, sensorName } from "../../widgets/joint_words.js";
import { lampPlaces, spread } from "./lamp_places.js";

const SIZE = 8.7; // half the width of a lamp, in units of the outline: 24 px on a figure of 280 px
const APART = 17.8; // between the middles of two lamps, at least
const SHAPES = {
  circle: () => h("circle", { r: SIZE }),
  diamond: () => h("path", { d: `M0 ${-SIZE * 1.3}L${SIZE * 1.3} 0 0 ${SIZE * 1.3} ${-SIZE * 1.3} 0Z` }),
  square: () => h("rect", { x: -SIZE, y: -SIZE, width: 2 * SIZE, height: 2 * SIZE, rx: 1 }),
  triangle: () => h("path", { d: `M0 ${-SIZE * 1.25}L${SIZE * 1.3} ${SIZE} ${-SIZE * 1.3} ${SIZE}Z` }),
};
/** @type {Record<string, {shape: keyof typeof SHAPES, sign: string}>} */
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

/** What a key moves the choice by. @type {Record<string, number | undefined>} */
const STEPS = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };

/** @typedef {ReturnType<typeof lampsOf>[number]} Lamp */

/** The sign of one quality, as it stands on the body and in the legend. @param {{quality: string}} lamp */
export function LampSign({ quality }) {
  const { shape, sign } = QUALITIES[quality] ?? QUALITIES.silent;
  return h(Fragment, {}, SHAPES[shape](), h("text", { y: 3.9, "text-anchor": "middle" }, sign));
}

/** A picture of one lamp. @param {{quality: string, size: number}} picture size: in px */
export function LampPicture({ quality, size }) {
  return h(
    "svg",
    { viewBox: "-12 -12 24 24", width: size, height: size, "aria-hidden": "true" },
    h("g", { class: "sensor", "data-quality": quality }, h(LampSign, { quality })),
  );
}

/**
 * Both sides of the body with a lamp for every channel.
 * @param {{layout: import("types/api").ShirtLayout, qualities: string[], moving: number[], picked: string,
 *   onPick: (name: string) => void}} body moving: indices of the channels whose lamps light up; picked: the name of a channel
 */
export function BodyLamps({ layout, qualities, moving, picked, onPick }) {
  const lamps = useMemo(() => lampsOf(layout.channels), [layout]);
  const labels = labelsOf(layout.joints);
  const elements = useRef(/** @type {(SVGGElement | null)[]} */ ([]));
  /** @param {KeyboardEvent} event @param {number} index of the lamp that has the focus */
  const press = (event, index) => {
    const step = STEPS[event.key];
    if (!step && event.key !== " " && event.key !== "Enter") return;
    event.preventDefault();
    const next = (index + (step ?? 0) + lamps.length) % lamps.length;
    onPick(lamps[next].channel.name);
    elements.current[next]?.focus();
  };
  /** @param {Lamp} lamp */
  const draw = ({ channel: { name, joint }, index, at: [x, y] }) => {
    const quality = qualities[index] ?? "silent";
    return h(
      "g",
      {
        key: name,
        class: "sensor",
        transform: `translate(${x} ${y})`,
        role: "radio",
        "data-quality": quality,
        "data-moving": moving.includes(index) ? "" : undefined,
        "aria-label": `${sensorName(name)}, ${labels[joint]}: ${t(`quality-${quality}`)}`,
        "aria-checked": name === picked,
        tabindex: name === picked || (!picked && index === 0) ? 0 : -1,
        ref: (/** @type {SVGGElement | null} */ element) => void (elements.current[index] = element),
        onKeyDown: (/** @type {KeyboardEvent} */ event) => press(event, index),
      },
      h(LampSign, { quality }),
    );
  };
  return h(
    "div",
    { class: "bodies", role: "radiogroup", "aria-label": t("shirt-sensors-label") },
    SIDES.map((side) => {
      const here = lamps.filter((lamp) => lamp.side === side);
      /** @param {MouseEvent} event */
      const pick = (event) => {
        const nearest = nearestLamp(here, event);
        if (nearest) onPick(nearest.channel.name);
      };
      return h(
        "figure",
        { key: side },
        h(
          "svg",
          { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, onClick: pick },
          h(Outline, { side }),
          h("g", {}, here.map(draw)),
        ),
        h("figcaption", {}, t(`shirt-${side}`)),
      );
    }),
  );
}

/** The lamps with their places in units of the outline. @param {import("./lamp_places.js").Channel[]} channels */
function lampsOf(channels) {
  const lamps = lampPlaces(channels).map((place) => ({ ...place, at: inDrawing(place.position) }));
  for (const side of SIDES) {
    const points = lamps.filter((lamp) => lamp.side === side).map(({ at }) => at);
    spread(points, APART, [WIDTH, HEIGHT]);
  }
  return lamps;
}

/** @param {Lamp[]} lamps of one picture @param {MouseEvent} event of that picture @returns {Lamp | null} */
function nearestLamp(lamps, event) {
  const at = pointIn(event);
  /** @param {Lamp} lamp */
  const distance = (lamp) => Math.hypot(lamp.at[0] - at.x, lamp.at[1] - at.y);
  const [first = null, ...others] = lamps;
  return others.reduce((best, lamp) => (best && distance(lamp) < distance(best) ? lamp : best), first);
}
