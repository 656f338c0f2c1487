/** The editor: tools, drawing and form round one state; every step can be taken back. */
import { h, put, set, write } from "../widgets/dom.js";
import { toggle } from "../widgets/fields.js";
import { icon } from "../widgets/icons.js";
import { sendUnderName } from "../widgets/same_name.js";
import { t } from "../texts.js";
import { actsOn } from "./acts.js";
import { checker, refOf } from "./check.js";
import { boundsOfPlan, movedBy, pointsOf, thing, thingAt } from "./document.js";
import { drawing, drawnWords } from "./drawing.js";
import { form } from "./form.js";
import { snapped, STEP, tidy } from "./geometry.js";
import { begun, redone, stepped, undone } from "./history.js";
import { listenToKeys } from "./keys.js";
import { listenToPointers } from "./pointers.js";
import { finished, placed, snapPlace, tapped, TOOLS, withTool } from "./tools.js";
import { viewButtons, ZOOM } from "./view_buttons.js";
import { fitting, panned, toPlace, zoomed } from "./viewport.js";

const REACH = 22; // px round a finger
const DOOR = 1; // m
const FINE = 0.01; // m of an arrow key without the grid

/**
 * @param {import("../main.js").App} app
 * @param {{plan: any, models: any[], signal: AbortSignal, onChange: (plan: any) => void}} given
 */
export function workbench(app, { plan, models, signal, onChange }) {
  let history = begun(plan);
  let state = { plan, tool: "move", pending: [], chosen: null, doorWidth: DOOR };
  let [view, size] = [
    { x: 4, y: 3, scale: 60 },
    { width: 1, height: 1 },
  ];
  let [ghost, cursor, dragged, verdict] = [null, null, null, null];
  let step = STEP;
  let known = models;

  const sheet = drawing(t("editor.sheet"));
  const panel = h("section", { class: "panel stack", "aria-label": t("editor.panel") });
  const verdictLine = h("p", { class: "verdict", role: "status" });
  const hint = h("p", { class: "quiet small hint" });
  const done = h(
    "button",
    { type: "button", class: "btn go small", onclick: () => take(finished(state)) },
    t("editor.done"),
  );
  const back = h("button", { type: "button", class: "btn small", onclick: () => undo() }, icon("undo"), t("undo"));
  const again = h("button", { type: "button", class: "btn small", onclick: () => redo() }, icon("redo"), t("redo"));
  const tools = TOOLS.map((tool) =>
    h(
      "button",
      { type: "button", class: "btn small", "data-tool": tool, onclick: () => take(withTool(state, tool)) },
      t(`editor.tool.${tool}`),
    ),
  );
  const checks = checker(app, (answer) => {
    verdict = answer;
    write(verdictLine, answer.good ? t("editor.good") : answer.sentence);
    verdictLine.className = answer.good ? "verdict good" : answer.begun ? "verdict" : "verdict bad";
    draw();
  });

  /** Go on to another state; a changed plan is a step that can be undone. */
  function take(next) {
    if (next.words) app.toasts.show(t(next.words));
    history = stepped(history, next.plan);
    const { words: _, ...rest } = next;
    become(rest);
  }

  function become(next) {
    const hasOtherPlan = next.plan !== state.plan;
    state = next;
    if (state.chosen && !thing(state.plan, state.chosen)) state = { ...state, chosen: null };
    if (hasOtherPlan) {
      onChange(state.plan);
      checks.later(state.plan);
    }
    show();
  }

  /** A line that is being drawn loses its last point first. */
  function undo() {
    if (state.pending.length) return become({ ...state, pending: state.pending.slice(0, -1) });
    history = undone(history);
    become({ ...state, plan: history.now, chosen: null });
  }

  function redo() {
    history = redone(history);
    become({ ...state, plan: history.now, chosen: null, pending: [] });
  }

  const how = () => ({ step, reach: REACH / view.scale });
  const isDrawing = () => !["move", "erase"].includes(state.tool);

  function draw() {
    const wrong = verdict && !verdict.good ? refOf(verdict.place) : null;
    const at = verdict && !verdict.good ? verdict.at : null;
    sheet.show(
      {
        plan: dragged ?? state.plan,
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
    put(hint, t(`editor.hint.${state.tool}`), " ", state.pending.length > 1 && drawnWords(state.pending));
    const key = panel.contains(document.activeElement) ? document.activeElement.dataset.key : null;
    put(
      panel,
      state.tool === "door" && doorWidth(),
      form({ plan: state.plan, chosen: state.chosen, models: known }, acts),
    );
    if (key) panel.querySelector(`[data-key="${key}"]`)?.focus();
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
    return h("div", { class: "field" }, h("label", { for: "door-width" }, t("editor.door-width")), input);
  }

  const acts = {
    ...actsOn(() => state, take, become),
    model: async (file) => {
      try {
        const listed = await sendUnderName(app.question, (sameName) =>
          app.api.upload(`/models?same_name=${sameName}`, file),
        );
        if (!listed) return;
        known = listed;
        app.toasts.show(t("editor.model.added", { file: file.name }));
        show();
      } catch (error) {
        app.toasts.show(error.message);
      }
    },
  };

  listenToPointers(
    sheet.element,
    {
      tap: (pixel) => {
        cursor = null;
        take(tapped(state, toPlace(view, size, pixel), how()));
      },
      hover: (pixel) => {
        ghost = pixel && isDrawing() ? snapPlace(state.plan, toPlace(view, size, pixel), step, how().reach) : null;
        if (isDrawing()) draw();
      },
      grab: (pixel) => {
        if (state.tool !== "move" || !state.chosen || state.chosen.list === "doors") return false;
        const found = thingAt(state.plan, toPlace(view, size, pixel), how().reach, state.chosen);
        if (!found || found.list !== state.chosen.list || found.index !== state.chosen.index) return false;
        state = { ...state, chosen: found };
        return true;
      },
      drag: (from, to) => {
        const [a, b] = [toPlace(view, size, from), toPlace(view, size, to)];
        const even = (value) => (step ? tidy(Math.round(value / step) * step) : tidy(value));
        dragged = movedBy(state.plan, state.chosen, even(b[0] - a[0]), even(b[1] - a[1]));
        draw();
      },
      drop: () => {
        const next = dragged;
        dragged = null;
        if (next) take({ ...state, plan: next });
      },
      pan: (dx, dy) => look(() => panned(view, dx, dy)),
      zoom: (factor, pixel) => look(() => zoomed(view, size, factor, pixel)),
    },
    signal,
  );

  function look(changed) {
    view = changed(view, size);
    draw();
  }

  listenToKeys(
    sheet.element,
    {
      /** Arrow keys move the chosen thing, or a cross where Enter taps. */
      arrow: (x, y) => {
        const [dx, dy] = [x, y].map((one) => one * (step || FINE));
        if (state.chosen && state.tool === "move") return nudge(dx, dy);
        const from = cursor ?? snapped([view.x, view.y], step || STEP);
        ghost = cursor = [tidy(from[0] + dx), tidy(from[1] + dy)];
        draw();
      },
      enter: () => take(cursor ? tapped(state, cursor, { step, reach: STEP }) : finished(state)),
      escape: () => {
        ghost = cursor = null;
        take({ ...withTool(state, "move"), chosen: null });
      },
      zoom: (isNearer) => look(() => zoomed(view, size, isNearer ? ZOOM : 1 / ZOOM)),
      erase: () => state.chosen && acts.erase(),
      undo,
      redo,
    },
    signal,
  );

  function nudge(dx, dy) {
    const [x, y] = pointsOf(state.plan, state.chosen)[state.chosen.point ?? 0];
    if (state.chosen.list === "doors") return take(placed(state, [x + dx, y + dy], 1));
    return take({ ...state, plan: movedBy(state.plan, state.chosen, dx, dy) });
  }

  const views = viewButtons(look, () => look(() => fitting(boundsOfPlan(state.plan), size)));
  const element = h(
    "div",
    { class: "bench" },
    h("div", { class: "tools", role: "toolbar", "aria-label": t("editor.tools") }, tools, back, again),
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
        toggle(t("editor.snap"), true, (on) => (step = on ? STEP : 0)),
      ),
    ),
    panel,
    verdictLine,
  );
  let isFitted = false;
  const resized = new ResizeObserver(([entry]) => {
    size = { width: Math.max(1, entry.contentRect.width), height: Math.max(1, entry.contentRect.height) };
    if (!isFitted) view = fitting(boundsOfPlan(state.plan), size);
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
      take(finished(state));
      return state.plan;
    },
  };
}
