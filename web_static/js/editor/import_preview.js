/** What a file became: its walls and path, how large it is and what was left out, before it is opened. */
import { h, s } from "../widgets/dom.js";
import { t } from "../texts.js";
import { points } from "../plan/plan_marks.js";

const MARGIN = 0.5; // m around the plan

/**
 * @typedef {import("types/api").DraftView} DraftView
 * @typedef {[number, number]} Point x, y in m
 * @typedef {{walls: Point[][], wall_thickness: number, paths: {points: Point[]}[]}} Drawn the part of a document that is shown
 */

/** @param {DraftView} draft @param {() => void} onOpen */
export function importPreview(draft, onOpen) {
  return h(
    "section",
    { class: "import-preview stack", "aria-label": t("import-preview") },
    h("h3", {}, t("import-preview")),
    // The API does not describe the document's fields.
    picture(/** @type {Drawn} */ (/** @type {unknown} */ (draft.document))),
    h(
      "ul",
      { class: "small" },
      draft.messages.map((message) => h("li", {}, message)),
    ),
    h("div", {}, h("button", { type: "button", class: "btn go", onclick: onOpen }, t("import-open"))),
  );
}

/** @param {Drawn} drawn */
function picture({ walls, wall_thickness: thickness, paths }) {
  const lines = paths.map((path) => path.points);
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of [...walls, ...lines].flat()) {
    box[0] = Math.min(box[0], x - MARGIN);
    box[1] = Math.min(box[1], y - MARGIN);
    box[2] = Math.max(box[2], x + MARGIN);
    box[3] = Math.max(box[3], y + MARGIN);
  }
  const [left, low, right, high] = box;
  const element = s(
    "svg",
    {
      class: "plan",
      viewBox: `${left} ${-high} ${right - left} ${high - low}`,
      role: "img",
      "aria-label": t("import-picture"),
    },
    s(
      "g",
      { transform: "scale(1 -1)" }, // the plan's y goes up, the picture's down
      s(
        "g",
        { class: "walls", "stroke-width": thickness },
        walls.map((wall) => s("polyline", { points: points(wall) })),
      ),
      lines.map((line) => s("polyline", { class: "prescribed path", points: points(line) })),
    ),
  );
  element.style.setProperty("--unit", String(Math.max(right - left, high - low) / 100));
  return element;
}
