/**
 * The visible part of the floor: the point in the middle (m), and pixels per metre.
 * @typedef {{x: number, y: number, scale: number}} View
 * @typedef {{width: number, height: number}} Size px
 */

const SMALLEST = 2; // px per m: some hundred metres on a tablet
const LARGEST = 400;
const FIRST = 60; // px per m of an empty plan
const MARGIN = 0.85; // of the picture that a plan fills

/** @param {View} view @param {Size} size @param {[number, number]} pixel from the upper left @returns {[number, number]} m */
export function toPlace(view, { width, height }, [px, py]) {
  return [view.x + (px - width / 2) / view.scale, view.y - (py - height / 2) / view.scale];
}

/** @param {View} view @param {Size} size @param {[number, number]} place @returns {[number, number]} px */
export function toPixel(view, { width, height }, [x, y]) {
  return [width / 2 + (x - view.x) * view.scale, height / 2 - (y - view.y) * view.scale];
}

/** @param {View} view @param {number} dx px @param {number} dy px @returns {View} */
export function panView(view, dx, dy) {
  return { ...view, x: view.x - dx / view.scale, y: view.y + dy / view.scale };
}

/**
 * Zoom; the point of the floor under a pixel stays under it.
 * @param {View} view @param {Size} size @param {number} factor @param {[number, number]} [pixel]
 */
export function zoomView(view, size, factor, pixel = [size.width / 2, size.height / 2]) {
  const [x, y] = toPlace(view, size, pixel);
  const scale = Math.min(LARGEST, Math.max(SMALLEST, view.scale * factor));
  const other = { ...view, scale };
  const [otherX, otherY] = toPlace(other, size, pixel);
  return { ...other, x: view.x + x - otherX, y: view.y + y - otherY };
}

/**
 * The view that shows everything.
 * @param {{x: number, y: number, width: number, height: number} | null} bounds m @param {Size} size @returns {View}
 */
export function fitView(bounds, { width, height }) {
  if (!bounds) return { x: 4, y: 3, scale: FIRST };
  const scale = MARGIN * Math.min(width / Math.max(bounds.width, 1), height / Math.max(bounds.height, 1));
  return {
    x: bounds.x + bounds.width / 2,
    y: bounds.y + bounds.height / 2,
    scale: Math.min(LARGEST, Math.max(SMALLEST, scale)),
  };
}
