/**
 * Both sides of the body with a mark for each channel that has a place. The chosen channel is put where somebody taps;
 * its mark can be dragged, and moved by arrow keys.
 * @import { ShirtLayout } from "types/api"
 * @import { Side } from "./layout_document.js"
 */
import { h, useRef } from "../../preact.js";
import { t } from "../../texts.js";
import { sensorName } from "../../widgets/joint_words.js";
import { HEIGHT, inDrawing, LAYOUT_HEIGHT, Outline, pointIn, SIDES, WIDTH } from "../shirt/body_outline.js";
import { lampPlaces } from "../shirt/lamp_places.js";
import { placeWords } from "./place_names.js";

const DOT = 5; // radius of a mark, in units of the outline
const REACH = 9; // radius in which a finger finds it
const FOCUSED = 16.5; // radius of what has the focus: 44 px on a figure of 280 px
const STEP = 0.01; // of the outline, by an arrow key
const FAR = 0.05; // with Shift
const SLOP = 0.01; // of the outline that a finger may slip without moving a mark
/** What a key moves the chosen mark by, in steps to the right and down. @type {Record<string, [number, number] | undefined>} */
const KEYS = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowDown: [0, 1], ArrowUp: [0, -1], Enter: [0, 0] };

/**
 * @typedef {[number, number]} Point in the shares of a layout
 * @typedef {object} Places
 * @property {ShirtLayout} layout @property {number} picked index of the chosen channel
 * @property {number[]} moving indices of the channels that move now
 * @property {(index: number) => void} onPick @property {(index: number, side: Side, position: Point) => void} onPlace
 */

/** @param {Places} places */
export function BodyPlaces(places) {
  const { layout, picked } = places;
  // A channel without a place stands near its joint while it is chosen, so that keys can begin there.
  const shown = lampPlaces(layout.channels).filter(({ channel, index }) => channel.position || index === picked);
  const inOrder = [...shown.filter(({ index }) => index !== picked), ...shown.filter(({ index }) => index === picked)];
  return h(
    "div",
    { class: "bodies place-figures" },
    SIDES.map((side) =>
      h(
        "figure",
        { key: side },
        h(Figure, { side, places, marks: inOrder.filter((mark) => mark.side === side) }),
        h("figcaption", {}, t(`shirt-${side}`)),
      ),
    ),
  );
}

/**
 * @typedef {ReturnType<typeof lampPlaces>[number]} Mark
 * @param {{side: Side, places: Places, marks: Mark[]}} figure
 */
function Figure({ side, places: { picked, moving, onPick, onPlace }, marks }) {
  /** The mark that the pointer has, where it was taken, and how far from its middle. */
  const grip = useRef(/** @type {{index: number, from: Point, offset: Point, isMoving: boolean} | null} */ (null));
  const ignoresClick = useRef(false); // a click follows, which puts no channel there
  /** @param {MouseEvent} event @returns {Point} where it is on the outline */
  const at = (event) => {
    const { x, y } = pointIn(event);
    return [x / WIDTH, y / LAYOUT_HEIGHT];
  };
  /** @param {PointerEvent} event */
  const grab = (event) => {
    const mark = marks.find(({ index }) => index === indexOf(event));
    ignoresClick.current = mark !== undefined;
    if (!mark) return;
    const from = at(event);
    grip.current = { index: mark.index, from, offset: between(mark.position, from), isMoving: false };
    /** @type {SVGSVGElement} */ (event.currentTarget).setPointerCapture(event.pointerId);
    onPick(mark.index);
  };
  /** @param {PointerEvent} event */
  const drag = (event) => {
    const { current: mark } = grip;
    if (!mark) return;
    const now = at(event);
    mark.isMoving ||= Math.hypot(...between(now, mark.from)) > SLOP;
    if (mark.isMoving) onPlace(mark.index, side, [now[0] + mark.offset[0], now[1] + mark.offset[1]]);
  };
  const release = () => void (grip.current = null);
  /** @param {MouseEvent} event */
  const tap = (event) => {
    if (!ignoresClick.current && picked >= 0) onPlace(picked, side, at(event));
  };
  /** @param {KeyboardEvent} event @param {Mark} mark */
  const press = (event, { index, position: [x, y] }) => {
    const step = KEYS[event.key];
    if (!step) return;
    event.preventDefault();
    const size = event.shiftKey ? FAR : STEP;
    onPlace(index, side, [x + step[0] * size, y + step[1] * size]);
  };
  return h(
    "svg",
    {
      viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
      onPointerDown: grab,
      onPointerMove: drag,
      onPointerUp: release,
      onPointerCancel: release,
      onClick: tap,
    },
    h(Outline, { side }),
    marks.map((mark) =>
      h(
        "g",
        {
          key: mark.index,
          class: "place-mark",
          "data-index": mark.index,
          "data-moving": moving.includes(mark.index) || undefined,
          "data-placed": mark.channel.position !== null || undefined,
          transform: `translate(${inDrawing(mark.position).join(" ")})`,
          ...(mark.index === picked ? sliderOf(mark, (event) => press(event, mark)) : { "aria-hidden": true }),
        },
        mark.index === picked && h("circle", { class: "place-focus", r: FOCUSED }),
        h("circle", { class: "place-reach", r: REACH }),
        h("circle", { class: "place-dot", r: DOT }),
      ),
    ),
  );
}

/** What makes the chosen mark a control. @param {Mark} mark @param {(event: KeyboardEvent) => void} onKeyDown */
function sliderOf({ channel, position }, onKeyDown) {
  return {
    role: /** @type {const} */ ("slider"),
    tabindex: 0,
    "aria-label": t("layouts-mark-label", { name: sensorName(channel.name) }),
    "aria-valuemin": 0,
    "aria-valuemax": 100,
    "aria-valuenow": Math.round(100 * position[0]),
    "aria-valuetext": placeWords(channel),
    onKeyDown,
  };
}

/** The index of the channel whose mark an event has hit; -1 for none. @param {Event} event */
function indexOf({ target }) {
  const mark = /** @type {Element} */ (target).closest(".place-mark");
  return mark ? Number(mark.getAttribute("data-index")) : -1;
}

/** How far `a` is from `b`. @param {Point} a @param {Point} b @returns {Point} */
const between = (a, b) => [a[0] - b[0], a[1] - b[1]];
