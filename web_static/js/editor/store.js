/**
 * The plan that is edited: its document, what is chosen, what can be undone, and whether it can be driven in.
 * @import { ModelView } from "types/api"
 * @import { Verdict } from "./check.js"
 * @import { Plan } from "./document.js"
 * @import { NextState, State } from "./tools.js"
 * @typedef {ReturnType<typeof editorStore>} EditorStore
 */
import { signal } from "../preact.js";
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { sendInMetres } from "../widgets/object_scale.js";
import { sendUnderName } from "../widgets/same_name.js";
import { actsOn } from "./acts.js";
import { checker } from "./check.js";
import { itemOf } from "./document.js";
import { STEP } from "./geometry.js";
import { addStep, newHistory, stepBack, stepForward } from "./history.js";
import { finishLine } from "./tools.js";

/**
 * @param {import("../main.js").App} app
 * @param {{plan: Plan, models: ModelView[], left: AbortSignal, onChange: (plan: Plan) => void}} given
 */
export function editorStore(app, { plan, models: first, left, onChange }) {
  const doorWidth = REFERENCE.numbers.door_width;
  const state = signal(/** @type {State} */ ({ plan, tool: "move", pending: [], chosen: null, doorWidth }));
  const history = signal(newHistory(plan));
  const verdict = signal(/** @type {Verdict | null} */ (null));
  const models = signal(first);
  const step = signal(STEP); // m, of the grid; 0: places do not snap to it
  const checks = checker(app, (answer) => void (verdict.value = answer));

  /** Go on to another state; a changed plan is a step that can be undone. @param {NextState} next */
  const take = ({ words, ...next }) => {
    if (words) app.toasts.show(t(words));
    history.value = addStep(history.value, next.plan);
    become(next);
  };
  /** @param {State} next */
  const become = (next) => {
    const hasOtherPlan = next.plan !== state.value.plan;
    const isThere = next.chosen && itemOf(next.plan, next.chosen);
    state.value = isThere ? next : { ...next, chosen: null };
    if (!hasOtherPlan) return;
    onChange(next.plan);
    checks.later(next.plan);
  };
  /** Undo the last point of the line that is being drawn, otherwise the last step. */
  const undo = () => {
    const { pending } = state.value;
    if (pending.length) return become({ ...state.value, pending: pending.slice(0, -1) });
    history.value = stepBack(history.value);
    become({ ...state.value, plan: history.value.now, chosen: null });
  };
  const redo = () => {
    history.value = stepForward(history.value);
    become({ ...state.value, plan: history.value.now, chosen: null, pending: [] });
  };
  /** The plan with the line that is still being drawn. */
  const finish = () => {
    take(finishLine(state.value));
    return state.value.plan;
  };
  /** Upload a 3D model. @param {File} file */
  const addModel = (file) =>
    app.toasts.attempt(async () => {
      const next = await sendUnderName(app.question, (sameName) =>
        sendInMetres(app.question, (metresPerUnit) =>
          app.api.upload(`/models?same_name=${sameName}${metresPerUnit}`, file),
        ),
      );
      if (!next) return;
      models.value = next;
      app.toasts.show(t("editor-model-added", { file: file.name }));
    });
  /** @type {import("./acts.js").Acts} */
  const acts = { ...actsOn(() => state.value, take, become), model: addModel };

  checks.later(plan);
  left.addEventListener("abort", () => checks.end());
  return { left, state, history, verdict, models, step, acts, take, become, undo, redo, finish };
}
