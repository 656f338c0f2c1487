/** The clinic's own floor plans: their list, or the editor of the plan on the workbench. */
import { readDraft } from "../../editor/draft_store.js";
import { showPlanList } from "../../editor/plan_list.js";
import { showPlan } from "../../editor/plan_page.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal: left, rest }) {
  const draft = rest[0] === "edit" ? readDraft() : null;
  const { api } = app;
  if (draft) {
    const [plans, models] = await Promise.all([api.get("/floorplans"), api.get("/models")]);
    if (!left.aborted) showPlan(app, root, { draft, plans, models, left });
  } else {
    const [plans, own] = await Promise.all([api.get("/floorplans"), api.get("/own-floorplans")]);
    if (!left.aborted) showPlanList(app, root, { plans, own });
  }
}
