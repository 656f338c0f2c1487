/** Floor plans of one's own: the list, and the editor of the one on the workbench. */
import { keptDraft } from "../../editor/draft_store.js";
import { showPlanList } from "../../editor/plan_list.js";
import { showPlan } from "../../editor/plan_page.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal, rest }) {
  const isEdited = rest[0] === "edit" && keptDraft();
  const [plans, other] = await Promise.all(
    ["/floorplans", isEdited ? "/models" : "/own-floorplans"].map((path) => app.api.get(path)),
  );
  if (signal.aborted) return;
  if (isEdited) showPlan(app, root, { plans, models: other, signal });
  else showPlanList(app, root, { plans, own: other });
}
