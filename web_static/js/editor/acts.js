/** What the form does to the chosen thing: each act is one step that can be undone. */
import { change, setPoints, thing, withoutPoint, withPointAfter } from "./document.js";
import { changedDoor } from "./doors.js";
import { erased, placed } from "./tools.js";

const ON_ITS_WALL = 1; // m that a door may be put beside its wall by numbers

/**
 * @param {() => any} now the state @param {(next: any) => void} take a step @param {(next: any) => void} become another state, which is no step
 * @returns {Omit<import("./form.js").Acts, "model">}
 */
export function actsOn(now, take, become) {
  const made = ({ plan, ref, problem }) =>
    take({ ...now(), plan, chosen: ref, words: problem && `editor.door.${problem}` });
  return {
    change: (fields) => take({ ...now(), plan: change(now().plan, now().chosen, fields) }),
    points: (points) => {
      const { plan, chosen } = now();
      if (chosen.list === "doors") take(placed(now(), points[0], ON_ITS_WALL));
      else take({ ...now(), plan: setPoints(plan, chosen, points) });
    },
    plan: (fields) => {
      const given = Object.entries(fields).filter(([, value]) => value !== null);
      take({ ...now(), plan: { ...now().plan, ...Object.fromEntries(given) } });
    },
    choose: (chosen) => become({ ...now(), chosen, tool: "move", pending: [] }),
    erase: () => take(erased(now(), now().chosen)),
    place: () => become({ ...now(), tool: "placing" }),
    door: (width) => {
      const { plan, chosen } = now();
      if (width) made(changedDoor(plan, chosen, thing(plan, chosen).position, width, ON_ITS_WALL));
    },
    insert: () => made(withPointAfter(now().plan, now().chosen)),
    drop: () => made(withoutPoint(now().plan, now().chosen)),
  };
}
