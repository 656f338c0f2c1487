/**
 * The parts of a floor plan as the server answers them; places on the floor.
 * @typedef {[number, number]} Point x, y in m
 * @typedef {[number, number, number]} Pose x, y in m, heading in rad
 * @typedef {import("types/api").FloorPlan} FloorPlan
 * @typedef {FloorPlan["paths"][number]} PrescribedPath
 * @typedef {PrescribedPath["task"]} Task
 * @typedef {import("types/api").Stage} Stage one part of a course
 * @typedef {FloorPlan["obstacles"][number]} Obstacle
 * @typedef {FloorPlan["doors"][number]} Door
 * @typedef {FloorPlan["gaps"][number]} Gap
 * @typedef {FloorPlan["movers"][number]} Mover
 */

/** @param {readonly number[]} from @param {readonly number[]} to @returns {number} rad, from x counter-clockwise */
export function heading(from, to) {
  return Math.atan2(to[1] - from[1], to[0] - from[0]);
}

/** Whether every number of a pose is known. @param {readonly (number | null)[]} pose @returns {pose is Pose} */
export function isPose(pose) {
  return pose.every(Number.isFinite);
}
