/** The form at the side: what is chosen, or the plan itself. */
import { Fragment, h, useFocusWithin } from "../preact.js";
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { Field, Selection } from "../widgets/fields.js";
import { number } from "../widgets/format.js";
import { fieldsOf, itemsOf, LISTS } from "./document.js";
import { Input, NumberRow, TextRow } from "./form.js";
import { ItemForm } from "./item_form.js";

const MOST_LISTED = 300; // items of one list

/**
 * @typedef {import("./acts.js").Acts} Acts
 * @typedef {import("./document.js").Plan} Plan
 * @typedef {import("./document.js").Ref} Ref
 */

/** @param {{store: import("./store.js").EditorStore}} panel */
export function Panel({ store: { state, models, acts, become } }) {
  useFocusWithin(".panel", ".panel select"); // of an item that is erased, the list is left
  const { plan, chosen, tool, doorWidth } = state.value;
  return h(
    "section",
    { class: "panel stack", "aria-label": t("editor-panel") },
    tool === "door" &&
      h(DoorWidth, { width: doorWidth, onChange: (width) => become({ ...state.value, doorWidth: width }) }),
    h(ItemList, { plan, chosen, acts }),
    chosen ? h(ItemForm, { plan, chosen, models: models.value, acts }) : h(PlanForm, { plan, acts }),
  );
}

/** The width of the next door. @param {{width: number, onChange: (width: number) => void}} row width: m */
function DoorWidth({ width, onChange }) {
  return h(
    Field,
    { label: t("editor-door-width") },
    h(Input, {
      type: "number",
      step: "0.05",
      min: 0.5,
      max: 5,
      value: String(width),
      onChange: ({ valueAsNumber }) => valueAsNumber > 0 && onChange(valueAsNumber),
    }),
  );
}

/**
 * All items of the plan by name, to choose one without tapping the drawing.
 * @param {{plan: Plan, chosen: Ref | null, acts: Acts}} list
 */
function ItemList({ plan, chosen, acts }) {
  const refs = LISTS.flatMap((list) =>
    itemsOf(plan, list)
      .slice(0, MOST_LISTED)
      .map((_, index) => ({ list, index })),
  );
  const options = refs.map((ref) => ({ value: keyOf(ref), label: nameOf(plan, ref) }));
  return h(
    Field,
    { label: t("editor-chosen") },
    h(Selection, {
      options: [{ value: "", label: t("editor-plan") }, ...options],
      chosen: chosen ? keyOf(chosen) : "",
      onChange: (value) => acts.choose(refs.find((ref) => keyOf(ref) === value) ?? null),
    }),
  );
}

/** @param {Ref} ref */
const keyOf = ({ list, index }) => `${list} ${index}`;

/** @param {Plan} plan @param {Ref} ref */
function nameOf(plan, ref) {
  const { title, label, name } = fieldsOf(plan, ref);
  return t(`editor-one-${ref.list}`, { number: ref.index + 1, name: title ?? label ?? name ?? "" });
}

/** @param {{plan: Plan, acts: Acts}} form */
function PlanForm({ plan, acts }) {
  return h(
    Fragment,
    {},
    h(TextRow, {
      label: t("editor-title"),
      value: plan.title,
      maxlength: 80,
      onChange: (title) => acts.plan({ title }),
    }),
    h(NumberRow, {
      label: t("editor-wall-height"),
      value: plan.wall_height ?? REFERENCE.numbers.wall_height,
      unit: "m",
      onChange: (wall_height) => acts.plan({ wall_height }),
    }),
    h(NumberRow, {
      label: t("editor-wall-thickness"),
      value: plan.wall_thickness ?? REFERENCE.numbers.wall_thickness,
      unit: "m",
      onChange: (wall_thickness) => acts.plan({ wall_thickness }),
    }),
    h("p", { class: "quiet small" }, t("editor-plan-hint", { radius: number(REFERENCE.numbers.chair_radius, 2) })),
  );
}
