/**
 * How a ring of sensors sits otherwise than on other people: a sentence, a picture of how to put it right, a choice.
 * @import { ComponentChildren } from "../../preact.js"
 * @import { Arrangement, JointResult } from "types/documents"
 */
import { Fragment, h } from "../../preact.js";
import { t } from "../../texts.js";
import { jointWithin } from "../../widgets/joint_words.js";

const SIZE = 220; // px, width of the picture, in whose middle the ring is
const HEIGHT = 128; // px
const WORDS = 50; // px, from the middle to where the words round the ring begin
const BESIDE = 10; // px beside the middle from which words stand left or right of the ring
const ROUND = 34; // px, radius of the ring of sensors
const TURN = 22; // px, radius of the arrow inside
const HEAD = 5; // px, half the width of an arrow's head
const MIRROR = 42; // px, half the length of the line about which the ring is mirrored

/** @param {{joint: JointResult, onSay: (isRight: boolean) => void}} card onSay: whether it sits right all the same */
export function Sitting({ joint, onSay }) {
  const within = jointWithin(joint);
  const { arrangement = {}, as_worn: asWorn = {} } = joint.prior ?? {};
  const turned = Object.entries(arrangement);
  if (turned.length)
    return h(
      Fragment,
      {},
      turned.map(([ring, sits]) => h(TurnedCard, { key: ring, joint: within, sits })),
      choice(t("result-sits-right"), t("result-sits-right-label", { joint: within }), () => onSay(true)),
    );
  if (!Object.keys(asWorn).length) return null;
  return h(
    Fragment,
    {},
    h("p", { class: "small" }, t("result-sits-left", { joint: within })),
    choice(t("result-sits-follow"), t("result-sits-follow-label", { joint: within }), () => onSay(false)),
  );
}

/** @param {string} words @param {string} label what it does, with its joint @param {() => void} onClick */
function choice(words, label, onClick) {
  return h("button", { type: "button", class: "btn small", "aria-label": label, onClick }, words);
}

/** @param {{joint: string, sits: Arrangement}} card joint: within a sentence */
function TurnedCard({ joint, sits }) {
  const { shift, mirrored, sensors } = sits;
  const words = mirrored
    ? t("result-sits-mirrored", { joint })
    : t("result-sits-shifted", { joint, count: back(shift, sensors), sensors });
  return h(
    "div",
    { class: "sits" },
    mirrored ? mirroredPicture(joint, sits) : shiftedPicture(joint, sits),
    h("div", { class: "small" }, h("p", {}, words), h("p", { class: "quiet" }, t("result-sits-lead"))),
  );
}

/** By how many sensors to turn the shirt, the shorter way round. @param {number} shift @param {number} sensors */
function back(shift, sensors) {
  return Math.min(shift, sensors - shift);
}

/** A function that returns a point of the ring, with the front of the limb at the top. @param {Arrangement} sits */
function points({ sensors, front }) {
  /** @param {number} place counted round the limb @param {number} radius */
  return (place, radius) => {
    const angle = (2 * Math.PI * (place - (front ?? 0))) / sensors - Math.PI / 2;
    return [SIZE / 2 + radius * Math.cos(angle), SIZE / 2 + radius * Math.sin(angle)];
  };
}

/**
 * The limb with its sensors, and its sides where they are known.
 * @param {string} label @param {Arrangement} sits @param {number[]} large places of large sensors
 * @param {number} first which one has the colour of the arrow @param {ComponentChildren} arrows
 */
function ring(label, sits, large, first, arrows) {
  const at = points(sits);
  const { sensors, front, outside } = sits;
  /** @param {string} side @param {number} place */
  const sideWords = (side, place) => {
    const [x, y] = at(place, WORDS);
    const beside = x - SIZE / 2;
    const anchor = Math.abs(beside) < BESIDE ? "middle" : beside < 0 ? "end" : "start";
    return h("text", { x, y, class: "side", "text-anchor": anchor }, t(`result-sits-side-${side}`));
  };
  return h(
    "svg",
    {
      class: "ring",
      viewBox: `0 ${(SIZE - HEIGHT) / 2} ${SIZE} ${HEIGHT}`,
      width: SIZE,
      height: HEIGHT,
      role: "img",
      "aria-label": label,
    },
    h("circle", { cx: SIZE / 2, cy: SIZE / 2, r: ROUND, class: "limb" }),
    Array.from({ length: sensors }, (_, place) => {
      const [cx, cy] = at(place, ROUND);
      return h("circle", {
        key: place,
        cx,
        cy,
        r: large.includes(place) ? 6 : 4,
        class: place === first ? "sensor first" : "sensor",
      });
    }),
    front !== null && [sideWords("front", front), sideWords("back", front + sensors / 2)],
    outside !== null && [sideWords("outside", outside), sideWords("inside", outside + sensors / 2)],
    arrows,
  );
}

/**
 * The way to turn the shirt back.
 * @param {string} joint @param {Arrangement} sits the sensor at place p belongs at p + `shift`
 */
function shiftedPicture(joint, sits) {
  const { shift, sensors } = sits;
  const at = points(sits);
  const isForwards = shift <= sensors - shift;
  const count = back(shift, sensors);
  const [from, to] = isForwards ? [0, count] : [count, 0];
  const [x0, y0] = at(from, TURN);
  const [x1, y1] = at(to, TURN);
  const [tipX, tipY] = at(to + (isForwards ? -0.35 : 0.35), TURN - 7);
  const label = t("result-sits-picture", { joint, count, sensors });
  const arrow = h("path", {
    d: `M ${x0} ${y0} A ${TURN} ${TURN} 0 0 ${isForwards ? 1 : 0} ${x1} ${y1} L ${tipX} ${tipY}`,
    class: "turn",
  });
  return ring(label, sits, [0, count], from, arrow);
}

/**
 * Which sensors have changed places: a dashed line that the ring is mirrored about, and an arrow across it.
 * @param {string} joint @param {Arrangement} sits the sensor at place p lies where `shift` - p should be
 */
function mirroredPicture(joint, sits) {
  const { shift, sensors } = sits;
  const at = points(sits);
  // Of the pairs that have changed places, the one farthest apart: a quarter of the ring from the line.
  const from = Math.round(shift / 2 + sensors / 4);
  const to = (((shift - from) % sensors) + sensors) % sensors;
  const [[x0, y0], [x1, y1]] = [at(from, TURN), at(to, TURN)];
  const [[ax, ay], [bx, by]] = [at(shift / 2, MIRROR), at((shift + sensors) / 2, MIRROR)];
  return ring(t("result-sits-picture-mirrored", { joint }), sits, [from % sensors, to], from % sensors, [
    h("path", { d: `M ${ax} ${ay} L ${bx} ${by}`, class: "mirror" }),
    h("path", { d: `M ${x0} ${y0} L ${x1} ${y1} ${head(x0, y0, x1, y1)} ${head(x1, y1, x0, y0)}`, class: "turn" }),
  ]);
}

/**
 * The head of an arrow from (x0, y0) at (x1, y1), as a part of a path.
 * @param {number} x0 @param {number} y0 @param {number} x1 @param {number} y1
 */
function head(x0, y0, x1, y1) {
  const length = Math.hypot(x1 - x0, y1 - y0);
  const [dx, dy] = [(HEAD * (x1 - x0)) / length, (HEAD * (y1 - y0)) / length];
  return `M ${x1 - dx - dy} ${y1 - dy + dx} L ${x1} ${y1} L ${x1 - dx + dy} ${y1 - dy - dx}`;
}
