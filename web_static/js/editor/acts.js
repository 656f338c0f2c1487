/** What the form does to the chosen item: each act is one step that can be undone. */
import { change, insertPoint, removePoint, setPoints } from "./document.js";
import { changeDoor, doorOf } from "./doors.js";
import { erase, placeChosen } from "./tools.js";

const WALL_REACH = 1; // m from a wall within which the numbers of a door may place it

/**
 * @typedef {import("./document.js").Plan} Plan
 * @typedef {import("./document.js").Ref} Ref
 * @typedef {import("./tools.js").State} State
 * @typedef {import("./tools.js").NextState} NextState
 */

/**
 * @param {() => State} now @param {(next: NextState) => void} take a step
 * @param {(next: State) => void} become another state, which is no step
 * @returns {Omit<import("./form.js").Acts, "model">}
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
