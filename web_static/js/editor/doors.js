/** Doors: a gap in a wall and a frame in it. The gap is made, moved and closed together with the frame. */
import { add, remove, thing } from "./document.js";
import { distance, heading, nearestOn, tidy } from "./geometry.js";

const SAME = 0.002; // m
const THICKNESS = 0.1; // m, of walls that do not say theirs

/** A wall's end is half as thick as the wall: the gap is wider than what is left between. @param {any} plan @param {number} width m, clear */
function gapOf(plan, width) {
  return width + (plan.wall_thickness ?? THICKNESS);
}

/**
 * Put a door into the wall that is nearest to a place.
 * @param {any} plan @param {import("./geometry.js").Place} place @param {number} width m, clear @param {number} reach m
 * @returns {{plan: any, ref: any} | {problem: "no-wall" | "too-short"}}
 */
export function withDoor(plan, place, width, reach) {
  const found = nearestPiece(plan.walls, place);
  if (!found || found.away > reach) return { problem: "no-wall" };
  const wall = plan.walls[found.wall];
  const [a, b] = [wall[found.piece], wall[found.piece + 1]];
  const [length, gap] = [distance(a, b), gapOf(plan, width)];
  if (length < gap - SAME) return { problem: "too-short" };
  const middle = Math.min(length - gap / 2, Math.max(gap / 2, found.along));
  const at = (along) => [tidy(a[0] + ((b[0] - a[0]) * along) / length), tidy(a[1] + ((b[1] - a[1]) * along) / length)];
  const before = [...wall.slice(0, found.piece + 1), at(middle - gap / 2)];
  const after = [at(middle + gap / 2), ...wall.slice(found.piece + 1)];
  const parts = [before, after].map(withoutRepeats).filter((part) => part.length > 1);
  const walls = plan.walls.flatMap((one, i) => (i === found.wall ? parts : [one]));
  const door = { position: at(middle), width, heading: tidy(turned(heading(a, b))) };
  return add({ ...plan, walls }, "doors", door);
}

/** Take a door away, and close its gap when it is still there. @param {any} plan @param {any} ref */
export function withoutDoor(plan, ref) {
  const door = thing(plan, ref);
  const left = remove(plan, ref);
  const half = gapOf(plan, door.width) / 2;
  const ends = [1, -1].map((side) => {
    const along = door.heading + (side * Math.PI) / 2;
    return [door.position[0] + half * Math.cos(along), door.position[1] + half * Math.sin(along)];
  });
  const [one, other] = ends.map((end) => endAt(left.walls, end));
  if (!one && !other) return left;
  if (!one || !other) {
    // The wall ended at the door, so that there was nothing left on its other side.
    const here = one ?? other;
    const rest = (one ? ends[1] : ends[0]).map(tidy);
    const longer = oriented(left.walls[here.wall], here.atStart);
    return { ...left, walls: left.walls.map((wall, i) => (i === here.wall ? joined(longer, [rest]) : wall)) };
  }
  const first = oriented(left.walls[one.wall], one.atStart);
  if (one.wall === other.wall)
    return { ...left, walls: left.walls.map((wall, i) => (i === one.wall ? joined(first, [first[0]]) : wall)) };
  const second = oriented(left.walls[other.wall], !other.atStart);
  const walls = left.walls.flatMap((wall, i) =>
    i === one.wall ? [joined(first, second)] : i === other.wall ? [] : [wall],
  );
  return { ...left, walls };
}

/** The same door elsewhere, or wider; as it was, when it does not fit. @param {any} plan @param {any} ref @param {import("./geometry.js").Place} place @param {number} width m @param {number} reach m */
export function changedDoor(plan, ref, place, width, reach) {
  const made = withDoor(withoutDoor(plan, ref), place, width, reach);
  return "problem" in made ? { ...made, plan, ref } : made;
}

function nearestPiece(walls, place) {
  let best = null;
  for (const [wall, points] of walls.entries())
    for (let piece = 0; piece + 1 < points.length; piece += 1) {
      const { along, away } = nearestOn(points[piece], points[piece + 1], place);
      if (!best || away < best.away) best = { wall, piece, along, away };
    }
  return best;
}

function endAt(walls, place) {
  for (const [wall, points] of walls.entries()) {
    if (distance(points[0], place) < SAME) return { wall, atStart: true };
    if (distance(points.at(-1), place) < SAME) return { wall, atStart: false };
  }
  return null;
}

/** A line that ends at the end which was found. */
function oriented(points, atStart) {
  return atStart ? points.toReversed() : points;
}

/** Two lines as one; points in the middle of a straight piece are left out where they join. */
function joined(first, second) {
  const straight = (a, b, c) => nearestOn(a, c, b).away < SAME;
  const points = [...first, ...second];
  for (const i of [first.length, first.length - 1])
    if (i > 0 && i + 1 < points.length && straight(points[i - 1], points[i], points[i + 1])) points.splice(i, 1);
  return points;
}

function withoutRepeats(points) {
  return points.filter((point, i) => i === 0 || distance(points[i - 1], point) > SAME);
}

/** Across a wall, rad within (−π, π]. */
function turned(angle) {
  const across = angle + Math.PI / 2;
  return across > Math.PI ? across - 2 * Math.PI : across;
}
