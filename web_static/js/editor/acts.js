/** What the form does to the chosen item: each act is one step that can be undone. */
import { change, insertPoint, removePoint, setPoints } from "./document.js";
import { changeDoor, doorOf } from "./doors.js";
import { erase, placeChosen } from "./tools.js";

const WALL_REACH = 1; // m from a wall within which the numbers of a door may place it

/**
 * @typedef {import("../plan/floor_plan.js").Point} Point
 * @typedef {import("./document.js").Fields} Fields
 * @typedef {import("./document.js").Plan} Plan
 * @typedef {import("./document.js").Ref} Ref
 * @typedef {import("./tools.js").State} State
 * @typedef {import("./tools.js").NextState} NextState
 */

/**
 * @typedef {object} Acts what the form does to the plan
 * @property {(fields: Fields) => void} change fields of the chosen item
 * @property {(points: Point[]) => void} points of the chosen item
 * @property {(fields: Fields) => void} plan null leaves a field as it is
 * @property {(ref: Ref | null) => void} choose
 * @property {() => void} erase the chosen item
 * @property {() => void} place the chosen item by the next tap
 * @property {(width: number | null) => void} door its width in m
 * @property {() => void} insert a point
 * @property {() => void} drop the chosen point
 * @property {(file: File) => void} model upload a 3D model
 */

/**
 * @param {() => State} now @param {(next: NextState) => void} take a step
 * @param {(next: State) => void} become another state, which is no step
 * @returns {Omit<Acts, "model">}
 */
export function actsOn(now, take, become) {
  /** @param {{plan: Plan, ref: Ref, problem?: import("./doors.js").DoorProblem}} change */
  const takeChange = ({ plan, ref, problem }) =>
    take({ ...now(), plan, chosen: ref, words: problem && `editor-door-${problem}` });
  return {
    change: (fields) => {
      const { plan, chosen } = now();
      if (chosen) take({ ...now(), plan: change(plan, chosen, fields) });
    },
    points: (points) => {
      const { plan, chosen } = now();
      if (chosen?.list === "doors") take(placeChosen(now(), points[0], WALL_REACH));
      else if (chosen) take({ ...now(), plan: setPoints(plan, chosen, points) });
    },
    plan: (fields) => {
      const given = Object.entries(fields).filter(([, value]) => value !== null);
      take({ ...now(), plan: { ...now().plan, ...Object.fromEntries(given) } });
    },
    choose: (chosen) => become({ ...now(), chosen, tool: "move", pending: [] }),
    erase: () => {
      const { chosen } = now();
      if (chosen) take(erase(now(), chosen));
    },
    place: () => become({ ...now(), tool: "placing" }),
    door: (width) => {
      const { plan, chosen } = now();
      if (width && chosen) takeChange(changeDoor(plan, chosen, doorOf(plan, chosen).position, width, WALL_REACH));
    },
    insert: () => {
      const { plan, chosen } = now();
      if (chosen) takeChange(insertPoint(plan, chosen));
    },
    drop: () => {
      const { plan, chosen } = now();
      if (chosen) takeChange(removePoint(plan, chosen));
    },
  };
}
