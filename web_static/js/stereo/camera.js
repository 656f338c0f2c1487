/**
 * Where an eye's camera stands, and which part of its picture plane is shown.
 *
 * Both cameras look straight ahead. What lies at the distance of convergence falls on the same spot of both pictures,
 * because each picture is cut off-centre; cameras turned towards each other would tilt the pictures against each other.
 */

/**
 * How far an eye is to the right of the middle between both, m.
 * @param {"left" | "right"} side of the page @param {{apart: number, swapped: boolean}} chosen
 */
export function aside(side, { apart, swapped }) {
  return ((side === "right") === swapped ? -1 : 1) * (apart / 2000);
}

/**
 * How far the picture is cut to the right of straight ahead, as a tangent.
 * @param {number} right m @param {number} convergence m
 */
export function cut(right, convergence) {
  return -right / convergence;
}

/**
 * Put the camera of a frame with the 3D view there; once more does nothing. It touches neither the field of view nor
 * the place and direction that the server gives.
 * @param {any} view the frame's window @param {number} right m @param {number} convergence m
 */
export function aim(view, right, convergence) {
  const viewer = view?.__viserMutable;
  const { camera, cameraControl } = viewer ?? {};
  if (!camera || !cameraControl) return;
  if (Math.abs(cameraControl.getFocalOffset().x - right) > 1e-7) cameraControl.setFocalOffset(right, 0, 0, false);
  // three.js takes the cut in millimetres of a film, whose width changes with the shape of the picture.
  const film = cut(right, convergence) * camera.getFilmWidth();
  if (Math.abs(camera.filmOffset - film) < 1e-7) return;
  camera.filmOffset = film;
  camera.updateProjectionMatrix();
  viewer.requestRender();
}
