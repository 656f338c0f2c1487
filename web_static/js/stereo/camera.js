/**
 * The place of each eye's camera, and the part of its picture plane that is shown.
 *
 * Both cameras look straight ahead. What lies at the distance of convergence falls on the same spot of both pictures,
 * because each picture is cut off-centre; cameras turned towards each other would tilt the pictures against each other.
 */

/** @typedef {"left" | "right"} Side of the page */

/**
 * The distance (m) of an eye to the right of the middle between both.
 * @param {Side} side @param {{apart: number, swapped: boolean}} chosen apart: mm
 */
export function offset(side, { apart, swapped }) {
  return ((side === "right") === swapped ? -1 : 1) * (apart / 2000);
}

/**
 * The shift of the shown part of the picture plane to the right of straight ahead, as a tangent.
 * @param {number} right m @param {number} convergence m
 */
export function shift(right, convergence) {
  return -right / convergence;
}

/**
 * Shift the camera in a frame with the 3D view; repeating it changes nothing. The field of view, and the place and
 * direction from the server, stay as they are.
 * @param {Window | null} view the frame's window @param {number} right m @param {number} convergence m
 */
export function aim(view, right, convergence) {
  const viewer = view?.__viserMutable;
  const { camera, cameraControl } = viewer ?? {};
  if (!viewer || !camera || !cameraControl) return;
  if (Math.abs(cameraControl.getFocalOffset().x - right) > 1e-7) cameraControl.setFocalOffset(right, 0, 0, false);
  // three.js takes the shift in millimetres of a film, whose width changes with the shape of the picture.
  const film = shift(right, convergence) * camera.getFilmWidth();
  if (Math.abs(camera.filmOffset - film) < 1e-7) return;
  camera.filmOffset = film;
  camera.updateProjectionMatrix();
  viewer.requestRender();
}
