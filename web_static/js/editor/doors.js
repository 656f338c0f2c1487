/**
 * Doors: a gap in a wall and a frame in it. The gap is made, moved and closed together with the frame.
 * @import { Point } from "../plan/floor_plan.js"
 * @import { Plan, Ref } from "./document.js"
 * @typedef {"no-wall" | "too-short"} DoorProblem why a door does not fit
 * @typedef {{wall: number, atStart: boolean}} WallEnd
 */
import { heading } from "../plan/floor_plan.js";
import { REFERENCE } from "../reference.js";
import { add, fieldsOf, remove } from "./document.js";
import { distance, nearestOn, tidy } from "./geometry.js";

const SAME = 0.002; // m

/**
 * The width (m) of the gap for a door: each wall end reaches into it by half the wall's thickness.
 * @param {Plan} plan @param {number} width m, clear
 */
function gapOf(plan, width) {
  return width + (plan.wall_thickness ?? REFERENCE.numbers.wall_thickness);
}

/**
 * Insert a door into the wall that is nearest to a place.
 * @param {Plan} plan @param {Point} place @param {number} width m, clear @param {number} reach m
 * @returns {{plan: Plan, ref: Ref} | {problem: DoorProblem}}
 */
export function insertDoor(plan, place, width, reach) {
  const nearest = nearestPiece(plan.walls, place);
  if (!nearest || nearest.away > reach) return { problem: "no-wall" };
  const wall = plan.walls[nearest.wall];
  const [a, b] = [wall[nearest.piece], wall[nearest.piece + 1]];
  const [length, gap] = [distance(a, b), gapOf(plan, width)];
  if (length < gap - SAME) return { problem: "too-short" };
  const middle = Math.min(length - gap / 2, Math.max(gap / 2, nearest.along));
  /** @param {number} along m from a @returns {Point} */
  const at = (along) => [tidy(a[0] + ((b[0] - a[0]) * along) / length), tidy(a[1] + ((b[1] - a[1]) * along) / length)];
  const before = [...wall.slice(0, nearest.piece + 1), at(middle - gap / 2)];
  const after = [at(middle + gap / 2), ...wall.slice(nearest.piece + 1)];
  const parts = [before, after].map(dropRepeats).filter((part) => part.length > 1);
  const walls = plan.walls.flatMap((one, i) => (i === nearest.wall ? parts : [one]));
  const door = { position: at(middle), width, heading: tidy(quarterTurn(heading(a, b))) };
  return add({ ...plan, walls }, "doors", door);
}

/** Remove a door, and close its gap when it still exists. @param {Plan} plan @param {Ref} ref @returns {Plan} */
export function removeDoor(plan, ref) {
  const door = doorOf(plan, ref);
  const rest = remove(plan, ref);
  const half = gapOf(plan, door.width) / 2;
  /** @param {1 | -1} side @returns {Point} */
  const gapEnd = (side) => {
    const along = door.heading + (side * Math.PI) / 2;
    return [door.position[0] + half * Math.cos(along), door.position[1] + half * Math.sin(along)];
  };
  const ends = [gapEnd(1), gapEnd(-1)];
  const [one, other] = ends.map((end) => wallEndAt(rest.walls, end));
  if (one && other) return { ...rest, walls: connect(rest.walls, one, other) };
  const only = one ?? other;
  if (!only) return rest;
  // The wall ended at the door: there is no wall on its other side.
  const [x, y] = one ? ends[1] : ends[0];
  const longer = joinLines(orient(rest.walls[only.wall], only.atStart), [[tidy(x), tidy(y)]]);
  return { ...rest, walls: rest.walls.map((wall, i) => (i === only.wall ? longer : wall)) };
}

/** Connect two wall ends by a straight piece. @param {Point[][]} walls @param {WallEnd} one @param {WallEnd} other */
function connect(walls, one, other) {
  const first = orient(walls[one.wall], one.atStart);
  if (one.wall === other.wall) return walls.map((wall, i) => (i === one.wall ? joinLines(first, [first[0]]) : wall));
  const second = orient(walls[other.wall], !other.atStart);
  return walls.flatMap((wall, i) => (i === one.wall ? [joinLines(first, second)] : i === other.wall ? [] : [wall]));
}

/**
 * Move a door or change its width; when it does not fit, leave it as it was.
 * @param {Plan} plan @param {Ref} ref @param {Point} place @param {number} width m, clear @param {number} reach m
 * @returns {{plan: Plan, ref: Ref, problem?: DoorProblem}}
 */
export function changeDoor(plan, ref, place, width, reach) {
  const made = insertDoor(removeDoor(plan, ref), place, width, reach);
  return "problem" in made ? { ...made, plan, ref } : made;
}

/** A door, with its defaults. @param {Plan} plan @param {Ref} ref */
export function doorOf(plan, ref) {
  const { position = [0, 0], width = REFERENCE.numbers.door_width, heading: through = 0 } = fieldsOf(plan, ref);
  return { position, width, heading: through };
}

/** The piece of a wall that is nearest to a place. @param {Point[][]} walls @param {Point} place */
function nearestPiece(walls, place) {
  /** @type {{wall: number, piece: number, along: number, away: number} | null} */
  let best = null;
  for (const [wall, points] of walls.entries())
    for (let piece = 0; piece + 1 < points.length; piece += 1) {
      const { along, away } = nearestOn(points[piece], points[piece + 1], place);
      if (!best || away < best.away) best = { wall, piece, along, away };
    }
  return best;
}

/**
 * The wall end at a place; null when there is none.
 * @param {Point[][]} walls @param {Point} place @returns {WallEnd | null}
 */
function wallEndAt(walls, place) {
  for (const [wall, points] of walls.entries()) {
    if (distance(points[0], place) < SAME) return { wall, atStart: true };
    if (distance(points[points.length - 1], place) < SAME) return { wall, atStart: false };
  }
  return null;
}

/**
 * A line in the direction in which the given end is its last point.
 * @param {Point[]} points @param {boolean} atStart whether the end is the first point now
 */
function orient(points, atStart) {
  return atStart ? points.toReversed() : points;
}

/**
 * Join two lines, without a point where the joint lies on a straight piece.
 * @param {Point[]} first @param {Point[]} second
 */
function joinLines(first, second) {
  /** @param {Point} a @param {Point} b @param {Point} c */
  const isStraight = (a, b, c) => nearestOn(a, c, b).away < SAME;
  const points = [...first, ...second];
  for (const i of [first.length, first.length - 1])
    if (i > 0 && i + 1 < points.length && isStraight(points[i - 1], points[i], points[i + 1])) points.splice(i, 1);
  return points;
}

/** @param {Point[]} points */
function dropRepeats(points) {
  return points.filter((point, i) => i === 0 || distance(points[i - 1], point) > SAME);
}

/** A heading turned left by a quarter turn, rad within (−π, π]. @param {number} angle rad */
function quarterTurn(angle) {
  const across = angle + Math.PI / 2;
  return across > Math.PI ? across - 2 * Math.PI : across;
}
