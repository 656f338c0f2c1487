/** The upper body, front and back, drawn by hand in a box of 200 by 216; the lamps of the sensors lie on it. */
import { t } from "../texts.js";
import { s } from "./dom.js";

export const WIDTH = 200;
export const HEIGHT = 216;

// The patient's half at the right of the picture, from the neck down the arm and up again to the hip. The other half mirrors it.
const SKIN = "M100 44 L108 44 C108.5 52 112 56 121 59.5 C137 64.5 147.5 69 151.5 82 C156 98 160 112 164.5 128 C170 146 176 166 181.5 184 " +
  "C186.5 193 188 203 184 208 C179.5 212.5 174 205 171.5 193 C165 172 157 155 151.5 139 C146 124 142 111 138.5 99 " +
  "C138 117 135 132 134 148 C133.5 164 137 182 140 206 C127 211 113 212 100 212";
const SLEEVE = "M113 56.5 C137 63 147.5 69 151.5 82 C156 98 160 112 164.5 128 C170 146 174.5 161 178.5 174.5 L168 179.5 " +
  "C162.5 165 157 153 151.5 139 C146 124 142 111 138.5 99 C138 117 135 132 134 148 C133.5 164 137 182 140 206 C127 211 113 212 100 212";
const NECKLINE = { front: "C112 68 106 73 100 73", back: "C110 61.5 105 63 100 63" };

/**
 * Draw one side of the body.
 * @param {"front" | "back"} side
 */
export function outline(side) {
  const neck = NECKLINE[side].replace("C", "").trim().split(/\s+/).map(Number);
  const collar = `M113 56.5 C${neck.join(" ")}`;
  const shirt = `M100 ${neck[5]} C${neck[2]} ${neck[3]} ${neck[0]} ${neck[1]} 113 56.5 ${SLEEVE.slice("M113 56.5 ".length)}`;
  const half = () => [
    s("path", { class: "skin", d: SKIN }),
    s("path", { class: "cloth", d: shirt }),
    s("path", { class: "seam", d: collar }),
    s("path", { class: "seam", d: "M138.5 99 C134 88 131 76 127 61.5" }),
    s("path", { class: "seam", d: "M149 133 C153 131 158 128.5 163 124" }),
  ];
  return s("g", { class: "figure", "aria-hidden": "true" },
    s("ellipse", { class: "skin", cx: 100, cy: 24, rx: 16.5, ry: 21 }),
    s("g", {}, half()),
    s("g", { transform: `translate(${WIDTH} 0) scale(-1 1)` }, half()),
    side === "back" && s("path", { class: "seam spine", d: "M100 66 C99 110 101 160 100 206" }),
    side === "front" && face(),
    sideWords(side));
}

function face() {
  return s("path", { class: "seam", d: "M94 22h.01M106 22h.01M96.5 33c2 1.8 5 1.8 7 0" });
}

/** Whose right this is: seen from the front, the patient's right is at the left of the picture. */
function sideWords(side) {
  const [first, second] = side === "front" ? ["shirt.right", "shirt.left"] : ["shirt.left", "shirt.right"];
  return [
    s("text", { class: "side", x: 14, y: 214, "text-anchor": "middle" }, t(first)),
    s("text", { class: "side", x: WIDTH - 14, y: 214, "text-anchor": "middle" }, t(second)),
  ];
}
