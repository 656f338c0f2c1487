/** The way of a task over its floor plan; its place is kept free until the plan has come. */
import { h, useLayoutEffect, useRef } from "../../preact.js";
import { planPicture } from "../../plan/plan_svg.js";
import { t } from "../../texts.js";

/** @param {{app: import("../../main.js").App, task: import("./task_words.js").Task, left: AbortSignal}} place */
export function PlanPlace({ app, task: { plan, path }, left }) {
  const place = useRef(/** @type {HTMLDivElement | null} */ (null));
  useLayoutEffect(() => {
    let isNewest = true;
    const draw = async () => {
      const whole = await app.api.get(`/floorplans/${plan.name}`).catch(() => null); // the start of the trial says why
      if (left.aborted || !isNewest) return;
      const request = whole?.paths.find(({ name }) => name === path.name);
      const label = t("drive-plan-label", { plan: plan.title, path: path.title });
      const picture = whole && request && planPicture(whole, request.points, { label, request }).element;
      place.current?.replaceChildren(...(picture ? [picture] : []));
    };
    draw();
    return () => void (isNewest = false);
  }, [plan.name, path.name]);
  return h("div", { class: "plan-place", ref: place });
}
