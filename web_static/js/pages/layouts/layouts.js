/**
 * The layouts of shirts: their list, or the editor of one of the clinic's own.
 * @import { Equipment, ShirtKind } from "types/documents"
 */
import { newestAnswer } from "../../live/newest_answer.js";
import { t } from "../../texts.js";
import { showLayoutEditor } from "./layout_editor.js";
import { showLayoutList } from "./layout_list.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal: left, rest }) {
  const [first, view, shirts] = await Promise.all([
    app.api.get("/layouts"),
    app.api.get("/equipment"),
    app.api.get("/equipment/shirts"),
  ]);
  if (left.aborted) return;
  const now = /** @type {Equipment} */ (view);
  const read = async () => /** @type {Equipment} */ (await app.api.get("/equipment"));
  const equipment = newestAnswer(app, left, now, read, { what: ["equipment"] });
  const kinds = /** @type {ShirtKind[]} */ (shirts);
  if (rest[0] !== "edit") return showLayoutList(app, root, { first, equipment, kinds, left });
  const entry = first.own.find(({ id }) => String(id) === rest[1]);
  if (!entry) throw new Error(t("layouts-gone"));
  showLayoutEditor(app, root, { entry, equipment, kinds, left });
}
