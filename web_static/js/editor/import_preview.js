/** What a file became: its walls and path, how large it is and what was left out, before it is opened. */
import { h } from "../preact.js";
import { t } from "../texts.js";
import { points } from "../plan/plan_marks.js";

const MARGIN = 0.5; // m around the plan

/**
 * @typedef {import("types/api").DraftView} DraftView
 * @typedef {[number, number]} Point x, y in m
 * @typedef {{walls: Point[][], wall_thickness: number, paths: {points: Point[]}[]}} Drawn the part of a document that is shown
 */

/** @param {{made: import("../preact.js").ReadonlySignal<DraftView | null>, onOpen: (draft: DraftView) => unknown}} preview */
export function ImportPreview({ made, onOpen }) {
  const draft = made.value;
  if (!draft) return null;
  return h(
    "section",
    { class: "import-preview stack", "aria-label": t("import-preview") },
    h("h3", {}, t("import-preview")),
    // The API does not describe the document's fields.
    h(Picture, { drawn: /** @type {Drawn} */ (/** @type {unknown} */ (draft.document)) }),
    h(
      "ul",
      { class: "small" },
      draft.messages.map((message, i) => h("li", { key: i }, message)),
    ),
    h("div", {}, h("button", { type: "button", class: "btn go", onClick: () => onOpen(draft) }, t("import-open"))),
  );
}

/** @param {{drawn: Drawn}} picture */
function Picture({ drawn: { walls, wall_thickness: thickness, paths } }) {
  const lines = paths.map((path) => path.points);
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of [...walls, ...lines].flat()) {
    box[0] = Math.min(box[0], x - MARGIN);
    box[1] = Math.min(box[1], y - MARGIN);
    box[2] = Math.max(box[2], x + MARGIN);
    box[3] = Math.max(box[3], y + MARGIN);
  }
  const [left, low, right, high] = box;
  return h(
    "svg",
    {
      class: "plan",
      viewBox: `${left} ${-high} ${right - left} ${high - low}`,
      role: "img",
      "aria-label": t("import-picture"),
      style: `--unit: ${Math.max(right - left, high - low) / 100}`,
    },
    h(
      "g",
      { transform: "scale(1 -1)" }, // the plan's y goes up, the picture's down
      h(
        "g",
        { class: "walls", "stroke-width": thickness },
        walls.map((wall, i) => h("polyline", { key: i, points: points(wall) })),
      ),
      lines.map((line, i) => h("polyline", { key: i, class: "prescribed path", points: points(line) })),
    ),
  );
}
