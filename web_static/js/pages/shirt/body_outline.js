/** The upper body, front and back, drawn by hand in a box of 200 by 228; the lamps of the sensors lie on it. */
import { h } from "../../preact.js";
import { t } from "../../texts.js";

export const WIDTH = 200;
export const HEIGHT = 228;
/** What 1 of a layout's y is in this drawing: layouts reach from the crown to the thighs, the drawing ends at the hem. */
export const LAYOUT_HEIGHT = 262;
export const SIDES = /** @type {const} */ (["front", "back"]);

/** @param {[number, number]} position of a layout @returns {[number, number]} in units of this drawing */
export const inDrawing = ([x, y]) => [x * WIDTH, y * LAYOUT_HEIGHT];

/** Where a pointer is in the picture whose event this is, in units of this drawing. @param {MouseEvent} event */
export function pointIn({ clientX, clientY, currentTarget }) {
  const picture = /** @type {SVGSVGElement} */ (currentTarget);
  return new DOMPoint(clientX, clientY).matrixTransform(picture.getScreenCTM()?.inverse());
}

// The patient's half at the right of the picture, from the neck down the arm and up again to the hip. The other half mirrors it.
const SHOULDER = "C143 54 153.5 58 157.5 72 C161 89 168 103 175 119";
const INNER_ARM =
  "C163 168 157 154 153 142 C148 127 145 112 141 97 C140 116 137 132 136 148 C135.5 166 140 188 143 216 C129 222 113 223 100 223";
const SKIN =
  `M100 43 L109 43 C109.5 48 113 50.5 126 52 ${SHOULDER} C181 135 186 160 191 184 ` +
  `C196 194 199 206 195 213 C191 219 184 213 181 204 C179 198 172 194 168.5 186 ${INNER_ARM}`;
const COLLAR = [114, 50.5];
const SLEEVE = `C118 51.2 122 51.6 126 52 ${SHOULDER} C180.5 134 185 156 189 175 L166.5 181 ${INNER_ARM}`;
// From the collar to the middle: two control points and the end.
const NECKLINE = { front: [112, 63, 106, 68, 100, 68], back: [110, 56, 105, 57, 100, 57] };

/** One side of the body. @param {{side: "front" | "back"}} outline */
export function Outline({ side }) {
  const [x1, y1, x2, y2, x, y] = NECKLINE[side];
  const collar = `M${COLLAR.join(" ")} C${x1} ${y1} ${x2} ${y2} ${x} ${y}`;
  const shirt = `M${x} ${y} C${x2} ${y2} ${x1} ${y1} ${COLLAR.join(" ")} ${SLEEVE}`;
  /** @param {string} kind @param {string} d */
  const path = (kind, d) => h("path", { class: kind, d });
  const half = () => [
    path("skin", SKIN),
    path("cloth", shirt),
    path("seam", collar),
    path("seam", "M141 97 C136 84 133 70 131 53"),
    path("seam", "M152 140 C159 138 167 133 177 125"),
  ];
  return h(
    "g",
    { class: "figure", "aria-hidden": "true" },
    h("ellipse", { class: "skin", cx: 100, cy: 24, rx: 16.5, ry: 21 }),
    h("g", {}, half()),
    h("g", { transform: `translate(${WIDTH} 0) scale(-1 1)` }, half()),
    side === "back" && path("seam spine", "M100 62 C99 110 101 160 100 220"),
    side === "front" && path("seam", "M94 22h.01M106 22h.01M96.5 33c2 1.8 5 1.8 7 0"), // the face
    sideWords(side),
  );
}

/** The words for left and right: seen from the front, the patient's right is at the left of the picture. @param {"front" | "back"} side */
function sideWords(side) {
  const [first, second] = side === "front" ? ["shirt-right", "shirt-left"] : ["shirt-left", "shirt-right"];
  return [
    h("text", { class: "side", x: 14, y: 225, "text-anchor": "middle" }, t(first)),
    h("text", { class: "side", x: WIDTH - 14, y: 225, "text-anchor": "middle" }, t(second)),
  ];
}
