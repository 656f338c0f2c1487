/**
 * The drawing of the plan that is edited, and what fingers, mouse and keys do on it.
 * @import { Point } from "../plan/floor_plan.js"
 * @import { Plan, Ref } from "./document.js"
 * @import { EditorStore } from "./store.js"
 * @import { ViewChange } from "./view_buttons.js"
 * @import { Size, View } from "./viewport.js"
 * @typedef {ReturnType<typeof planSheet>} PlanSheet
 */
import { isWriting } from "../shell/stop.js";
import { t } from "../texts.js";
import { refAt } from "./check.js";
import { boundsOfPlan, itemNear, moveBy, pointsOf } from "./document.js";
import { drawing } from "./drawing.js";
import { STEP, tidy } from "./geometry.js";
import { listenToKeys } from "./keys.js";
import { listenToPointers } from "./pointers.js";
import { REACH, snap, snapPlace } from "./snap.js";
import { finishLine, placeChosen, tap, withTool } from "./tools.js";
import { ZOOM } from "./view_buttons.js";
import { fitView, panView, toPlace, zoomView } from "./viewport.js";

const FINE = 0.01; // m, step of an arrow key without the grid

/** @param {EditorStore} store */
export function planSheet({ left, state, verdict, step, acts, take, become, undo, redo }) {
  const { element, show } = drawing(t("editor-sheet"));
  /** @type {View} */
  let view = { x: 4, y: 3, scale: 60 };
  /** @type {Size} */
  let size = { width: 1, height: 1 };
  let isFitted = false;
  /** The place of the next tap. @type {Point | null} */
  let ghost = null;
  /** The place that the arrow keys have reached. @type {Point | null} */
  let cursor = null;
  /** The plan with the item that is being dragged. @type {Plan | null} */
  let dragPlan = null;

  const how = () => ({ step: step.value, reach: REACH / view.scale });
  const isDrawing = () => state.value.tool !== "move" && state.value.tool !== "erase";

  const draw = () => {
    const { plan, pending, chosen } = state.value;
    const bad = verdict.value && !verdict.value.good ? verdict.value : null;
    show(
      {
        plan: dragPlan ?? plan,
        pending,
        chosen,
        ghost: isDrawing() ? ghost : null,
        cursor,
        wrong: bad && refAt(bad.place),
        at: bad && bad.at,
      },
      view,
      size,
    );
  };
  /** @param {ViewChange} change */
  const look = (change) => {
    view = change(view, size);
    draw();
  };
  const showAll = () => look(() => fitView(boundsOfPlan(state.value.plan), size));
  /** @param {Ref} chosen @param {number} dx m @param {number} dy m */
  const nudge = (chosen, dx, dy) => {
    const { plan } = state.value;
    const [x, y] = pointsOf(plan, chosen)[chosen.point ?? 0];
    if (chosen.list === "doors") return take(placeChosen(state.value, [x + dx, y + dy], 1));
    return take({ ...state.value, plan: moveBy(plan, chosen, dx, dy) });
  };

  listenToPointers(
    element,
    {
      tap: (pixel) => {
        leaveField();
        cursor = null;
        take(tap(state.value, toPlace(view, size, pixel), how()));
      },
      hover: (pixel) => {
        const { step: grid, reach } = how();
        ghost = pixel && isDrawing() ? snapPlace(state.value.plan, toPlace(view, size, pixel), grid, reach) : null;
        if (isDrawing()) draw();
      },
      grab: (pixel) => {
        const { tool, plan, chosen } = state.value;
        if (tool !== "move" || !chosen || chosen.list === "doors") return false;
        const near = itemNear(plan, toPlace(view, size, pixel), how().reach, chosen);
        if (!near || near.list !== chosen.list || near.index !== chosen.index) return false;
        leaveField();
        become({ ...state.value, chosen: near });
        return true;
      },
      drag: (from, to) => {
        const { plan, chosen } = state.value;
        if (!chosen) return;
        const [a, b] = [toPlace(view, size, from), toPlace(view, size, to)];
        /** @param {number} value m */
        const even = (value) => (step.value ? tidy(Math.round(value / step.value) * step.value) : tidy(value));
        dragPlan = moveBy(plan, chosen, even(b[0] - a[0]), even(b[1] - a[1]));
        draw();
      },
      drop: () => {
        const next = dragPlan;
        dragPlan = null;
        if (next) take({ ...state.value, plan: next });
      },
      pan: (dx, dy) => look(() => panView(view, dx, dy)),
      zoom: (factor, pixel) => look(() => zoomView(view, size, factor, pixel)),
    },
    left,
  );
  listenToKeys(
    element,
    {
      // Arrow keys move the chosen item, or else a cross at which Enter taps.
      arrow: (x, y) => {
        const { tool, chosen } = state.value;
        const [dx, dy] = [x * (step.value || FINE), y * (step.value || FINE)];
        if (chosen && tool === "move") return nudge(chosen, dx, dy);
        const from = cursor ?? snap([view.x, view.y], step.value || STEP);
        ghost = cursor = [tidy(from[0] + dx), tidy(from[1] + dy)];
        draw();
      },
      enter: () => take(cursor ? tap(state.value, cursor, { step: step.value, reach: STEP }) : finishLine(state.value)),
      escape: () => {
        ghost = cursor = null;
        take({ ...withTool(state.value, "move"), chosen: null });
      },
      zoom: (isNearer) => look(() => zoomView(view, size, isNearer ? ZOOM : 1 / ZOOM)),
      erase: () => acts.erase(),
      undo,
      redo,
    },
    left,
  );
  const resized = new ResizeObserver(([{ contentRect }]) => {
    size = { width: Math.max(1, contentRect.width), height: Math.max(1, contentRect.height) };
    if (!isFitted) view = fitView(boundsOfPlan(state.value.plan), size);
    isFitted = true;
    draw();
  });
  resized.observe(element);
  left.addEventListener("abort", () => resized.disconnect());
  for (const shown of [state, verdict]) left.addEventListener("abort", shown.subscribe(draw));
  return { element, look, showAll };
}

/** A field gives what is typed in it to the item that is chosen now, before another one is. */
function leaveField() {
  const { activeElement: field } = document;
  if (field instanceof HTMLElement && isWriting(field)) field.blur();
}
