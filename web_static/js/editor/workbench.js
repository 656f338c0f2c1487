/** The editor: tools, drawing and form around one state; every step can be undone. */
import { h, put, set, write } from "../widgets/dom.js";
import { toggle } from "../widgets/fields.js";
import { icon } from "../widgets/icons.js";
import { sendInMetres } from "../widgets/object_scale.js";
import { sendUnderName } from "../widgets/same_name.js";
import { t } from "../texts.js";
import { actsOn } from "./acts.js";
import { checker, refAt } from "./check.js";
import { boundsOfPlan, itemNear, itemOf, moveBy, pointsOf } from "./document.js";
import { drawing, lineWords } from "./drawing.js";
import { form } from "./form.js";
import { STEP, tidy } from "./geometry.js";
import { addStep, newHistory, stepBack, stepForward } from "./history.js";
import { listenToKeys } from "./keys.js";
import { listenToPointers } from "./pointers.js";
import { snap, snapPlace } from "./snap.js";
import { finishLine, placeChosen, tap, TOOLS, withTool } from "./tools.js";
import { viewButtons, ZOOM } from "./view_buttons.js";
import { fitView, panView, toPlace, zoomView } from "./viewport.js";

const REACH = 22; // px around a finger
const DOOR = 1; // m, width of a new door
const FINE = 0.01; // m, step of an arrow key without the grid

/**
 * @typedef {import("../plan/floor_plan.js").Point} Point
 * @typedef {import("./document.js").Plan} Plan
 * @typedef {import("./tools.js").State} State
 */

/**
 * @param {import("../main.js").App} app
 * @param {{plan: Plan, models: import("types/api").ModelView[], signal: AbortSignal, onChange: (plan: Plan) => void}} given
 */
export function workbench(app, { plan, models, signal, onChange }) {
  let history = newHistory(plan);
  /** @type {State} */
  let state = { plan, tool: "move", pending: [], chosen: null, doorWidth: DOOR };
  /** @type {import("./viewport.js").View} */
  let view = { x: 4, y: 3, scale: 60 };
  /** @type {import("./viewport.js").Size} */
  let size = { width: 1, height: 1 };
  /** @type {Point | null} */
  let ghost = null;
  /** @type {Point | null} */
  let cursor = null;
  /** The plan with the item that is being dragged. @type {Plan | null} */
  let dragPlan = null;
  /** @type {import("./check.js").Verdict | null} */
  let verdict = null;
  let step = STEP;
  let modelList = models;

  const sheet = drawing(t("editor-sheet"));
  const panel = h("section", { class: "panel stack", "aria-label": t("editor-panel") });
  const verdictLine = h("p", { class: "verdict", role: "status" });
  const hint = h("p", { class: "quiet small hint" });
  const done = h(
    "button",
    { type: "button", class: "btn go small", onclick: () => take(finishLine(state)) },
    t("editor-done"),
  );
  const back = h("button", { type: "button", class: "btn small", onclick: () => undo() }, icon("undo"), t("undo"));
  const again = h("button", { type: "button", class: "btn small", onclick: () => redo() }, icon("redo"), t("redo"));
  const tools = TOOLS.map((tool) =>
    h(
      "button",
      { type: "button", class: "btn small", "data-tool": tool, onclick: () => take(withTool(state, tool)) },
      t(`editor-tool-${tool}`),
    ),
  );
  const checks = checker(app, (answer) => {
    verdict = answer;
    write(verdictLine, answer.good ? t("editor-good") : answer.sentence);
    verdictLine.className = answer.good ? "verdict good" : answer.isIncomplete ? "verdict" : "verdict bad";
    draw();
  });

  /** Go on to another state; a changed plan is a step that can be undone. @param {import("./tools.js").NextState} next */
  function take(next) {
    if (next.words) app.toasts.show(t(next.words));
    history = addStep(history, next.plan);
    const { words: _, ...rest } = next;
    become(rest);
  }

  /** @param {State} next */
  function become(next) {
    const hasOtherPlan = next.plan !== state.plan;
    state = next;
    if (state.chosen && !itemOf(state.plan, state.chosen)) state = { ...state, chosen: null };
    if (hasOtherPlan) {
      onChange(state.plan);
      checks.later(state.plan);
    }
    show();
  }

  /** Undo the last point of the line that is being drawn, otherwise the last step. */
  function undo() {
    if (state.pending.length) return become({ ...state, pending: state.pending.slice(0, -1) });
    history = stepBack(history);
    become({ ...state, plan: history.now, chosen: null });
  }

  function redo() {
    history = stepForward(history);
    become({ ...state, plan: history.now, chosen: null, pending: [] });
  }

  const how = () => ({ step, reach: REACH / view.scale });
  const isDrawing = () => state.tool !== "move" && state.tool !== "erase";

  function draw() {
    const wrong = verdict && !verdict.good ? refAt(verdict.place) : null;
    const at = verdict && !verdict.good ? verdict.at : null;
    sheet.show(
      {
        plan: dragPlan ?? state.plan,
        pending: state.pending,
        chosen: state.chosen,
        ghost: isDrawing() ? ghost : null,
        cursor,
        wrong,
        at,
      },
      view,
      size,
    );
  }

  function show() {
    for (const button of tools) set(button, { "aria-pressed": String(button.dataset.tool === state.tool) });
    back.disabled = !history.past.length && !state.pending.length;
    again.disabled = !history.future.length;
    done.hidden = state.pending.length < 2 || !["wall", "path"].includes(state.tool);
    put(hint, t(`editor-hint-${state.tool}`), " ", state.pending.length > 1 && lineWords(state.pending));
    const focused = document.activeElement;
    const key = focused instanceof HTMLElement && panel.contains(focused) ? focused.dataset.key : null;
    put(
      panel,
      state.tool === "door" && doorWidth(),
      form({ plan: state.plan, chosen: state.chosen, models: modelList }, acts),
    );
    /** @type {HTMLElement | null} */
    const successor = key ? panel.querySelector(`[data-key="${key}"]`) : null;
    successor?.focus();
    draw();
  }

  function doorWidth() {
    const input = h("input", {
      type: "number",
      step: "0.05",
      min: 0.5,
      max: 5,
      value: state.doorWidth,
      id: "door-width",
      "data-key": "door-width",
    });
    input.addEventListener(
      "change",
      () => input.valueAsNumber > 0 && become({ ...state, doorWidth: input.valueAsNumber }),
    );
    return h("div", { class: "field" }, h("label", { for: "door-width" }, t("editor-door-width")), input);
  }

  /** @type {import("./form.js").Acts} */
  const acts = {
    ...actsOn(() => state, take, become),
    model: (file) =>
      app.toasts.attempt(async () => {
        const next = await sendUnderName(app.question, (sameName) =>
          sendInMetres(app.question, (metresPerUnit) =>
            app.api.upload(`/models?same_name=${sameName}${metresPerUnit}`, file),
          ),
        );
        if (!next) return;
        modelList = next;
        app.toasts.show(t("editor-model-added", { file: file.name }));
        show();
      }),
  };

  listenToPointers(
    sheet.element,
    {
      tap: (pixel) => {
        cursor = null;
        take(tap(state, toPlace(view, size, pixel), how()));
      },
      hover: (pixel) => {
        ghost = pixel && isDrawing() ? snapPlace(state.plan, toPlace(view, size, pixel), step, how().reach) : null;
        if (isDrawing()) draw();
      },
      grab: (pixel) => {
        if (state.tool !== "move" || !state.chosen || state.chosen.list === "doors") return false;
        const near = itemNear(state.plan, toPlace(view, size, pixel), how().reach, state.chosen);
        if (!near || near.list !== state.chosen.list || near.index !== state.chosen.index) return false;
        state = { ...state, chosen: near };
        return true;
      },
      drag: (from, to) => {
        if (!state.chosen) return;
        const [a, b] = [toPlace(view, size, from), toPlace(view, size, to)];
        /** @param {number} value m */
        const even = (value) => (step ? tidy(Math.round(value / step) * step) : tidy(value));
        dragPlan = moveBy(state.plan, state.chosen, even(b[0] - a[0]), even(b[1] - a[1]));
        draw();
      },
      drop: () => {
        const next = dragPlan;
        dragPlan = null;
        if (next) take({ ...state, plan: next });
      },
      pan: (dx, dy) => look(() => panView(view, dx, dy)),
      zoom: (factor, pixel) => look(() => zoomView(view, size, factor, pixel)),
    },
    signal,
  );

  /** @param {import("./view_buttons.js").ViewChange} change */
  function look(change) {
    view = change(view, size);
    draw();
  }

  listenToKeys(
    sheet.element,
    {
      // Arrow keys move the chosen item, or else a cross at which Enter taps.
      arrow: (x, y) => {
        const [dx, dy] = [x * (step || FINE), y * (step || FINE)];
        if (state.chosen && state.tool === "move") return nudge(state.chosen, dx, dy);
        const from = cursor ?? snap([view.x, view.y], step || STEP);
        ghost = cursor = [tidy(from[0] + dx), tidy(from[1] + dy)];
        draw();
      },
      enter: () => take(cursor ? tap(state, cursor, { step, reach: STEP }) : finishLine(state)),
      escape: () => {
        ghost = cursor = null;
        take({ ...withTool(state, "move"), chosen: null });
      },
      zoom: (isNearer) => look(() => zoomView(view, size, isNearer ? ZOOM : 1 / ZOOM)),
      erase: () => acts.erase(),
      undo,
      redo,
    },
    signal,
  );

  /** @param {import("./document.js").Ref} chosen @param {number} dx m @param {number} dy m */
  function nudge(chosen, dx, dy) {
    const [x, y] = pointsOf(state.plan, chosen)[chosen.point ?? 0];
    if (chosen.list === "doors") return take(placeChosen(state, [x + dx, y + dy], 1));
    return take({ ...state, plan: moveBy(state.plan, chosen, dx, dy) });
  }

  const views = viewButtons(look, () => look(() => fitView(boundsOfPlan(state.plan), size)));
  const element = h(
    "div",
    { class: "bench" },
    h("div", { class: "tools", role: "toolbar", "aria-label": t("editor-tools") }, tools, back, again),
    h(
      "div",
      { class: "sheet-place" },
      sheet.element,
      views,
      h(
        "div",
        { class: "sheet-foot" },
        hint,
        done,
        toggle(t("editor-snap"), true, (on) => (step = on ? STEP : 0)),
      ),
    ),
    panel,
    verdictLine,
  );
  let isFitted = false;
  const resized = new ResizeObserver(([entry]) => {
    size = { width: Math.max(1, entry.contentRect.width), height: Math.max(1, entry.contentRect.height) };
    if (!isFitted) view = fitView(boundsOfPlan(state.plan), size);
    isFitted = true;
    draw();
  });
  resized.observe(sheet.element);
  signal.addEventListener("abort", () => {
    resized.disconnect();
    checks.end();
  });
  checks.later(plan);
  show();
  return {
    element,
    /** The plan with the line that is still being drawn. */
    plan: () => {
      take(finishLine(state));
      return state.plan;
    },
  };
}
