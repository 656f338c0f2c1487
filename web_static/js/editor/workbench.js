/**
 * The editor: tools, drawing and form around one plan.
 * @import { PlanSheet } from "./sheet.js"
 * @import { EditorStore } from "./store.js"
 */
import { h, useFocusWithin } from "../preact.js";
import { t } from "../texts.js";
import { Toggle } from "../widgets/fields.js";
import { number } from "../widgets/format.js";
import { Icon } from "../widgets/icons.js";
import { Made } from "../widgets/made.js";
import { lengthOf, STEP } from "./geometry.js";
import { Panel } from "./panel.js";
import { finishLine, TOOLS, withTool } from "./tools.js";
import { ViewButtons } from "./view_buttons.js";

/** @param {{store: EditorStore, sheet: PlanSheet}} bench */
export function Workbench({ store, sheet: { element, look, showAll } }) {
  return h(
    "div",
    { class: "bench" },
    h(Tools, { store }),
    h(
      "div",
      { class: "sheet-place" },
      h(Made, { class: "in-place", left: store.left, make: () => element }),
      h(ViewButtons, { look, showAll }),
      h(SheetFoot, { store }),
    ),
    h(Panel, { store }),
    h(VerdictLine, { store }),
  );
}

/** @param {{store: EditorStore}} tools */
function Tools({ store: { state, history, take, undo, redo } }) {
  const { tool, pending } = state.value;
  const { past, future } = history.value;
  const [cannotUndo, cannotRedo] = [!past.length && !pending.length, !future.length];
  return h(
    "div",
    { class: "tools", role: "toolbar", "aria-label": t("editor-tools") },
    TOOLS.map((one) =>
      h(
        "button",
        {
          key: one,
          type: "button",
          class: "btn small",
          "aria-pressed": one === tool,
          onClick: () => take(withTool(state.value, one)),
        },
        t(`editor-tool-${one}`),
      ),
    ),
    h(
      "button",
      {
        type: "button",
        class: "btn small",
        "aria-disabled": cannotUndo || undefined,
        onClick: () => void (cannotUndo || undo()),
      },
      h(Icon, { name: "undo" }),
      t("undo"),
    ),
    h(
      "button",
      {
        type: "button",
        class: "btn small",
        "aria-disabled": cannotRedo || undefined,
        onClick: () => void (cannotRedo || redo()),
      },
      h(Icon, { name: "redo" }),
      t("redo"),
    ),
  );
}

/** What the tool needs next, and the grid. @param {{store: EditorStore}} foot */
function SheetFoot({ store: { state, step, take } }) {
  useFocusWithin(".sheet-foot", ".sheet"); // the line is done
  const { tool, pending } = state.value;
  const isLine = pending.length > 1;
  const drawn = () => t("editor-drawn", { count: pending.length, length: number(lengthOf(pending), 2) });
  return h(
    "div",
    { class: "sheet-foot" },
    h("p", { class: "quiet small hint" }, t(`editor-hint-${tool}`), " ", isLine && h("span", {}, drawn())),
    h(
      "button",
      {
        type: "button",
        class: "btn go small",
        hidden: !isLine || !["wall", "path"].includes(tool),
        onClick: () => take(finishLine(state.value)),
      },
      t("editor-done"),
    ),
    h(Toggle, { label: t("editor-snap"), on: step.value > 0, onChange: (on) => void (step.value = on ? STEP : 0) }),
  );
}

/** Whether the plan can be driven in. @param {{store: EditorStore}} line */
function VerdictLine({ store: { verdict } }) {
  const now = verdict.value;
  const kind = !now || now.isIncomplete ? "" : now.good ? " good" : " bad";
  return h("p", { class: `verdict${kind}`, role: "status" }, now && (now.good ? t("editor-good") : now.sentence));
}
