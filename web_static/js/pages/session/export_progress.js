/**
 * How far an export is that was begun by a link: words and a bar, asked for by the id that the link carries.
 * @import { ExportCourseView } from "types/api"
 */
import { h, useLayoutEffect, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { size } from "../../widgets/format.js";

const ASK_EVERY = 1000; // ms
const MOST_UNKNOWN = 30; // answers in which the export has not begun: then it was refused, and the browser says why

/** @param {{app: import("../../main.js").App, left: AbortSignal, id: string}} progress id: "" before an export */
export function ExportProgress({ app, left, id }) {
  const course = useSignal(/** @type {ExportCourseView | "begun" | null} */ (null)); // null: nothing is to be seen
  useLayoutEffect(() => {
    if (!id) return;
    let timer = 0;
    const gone = new AbortController();
    const end = AbortSignal.any([left, gone.signal]);
    end.addEventListener("abort", () => clearTimeout(timer));
    /** @param {number} unknown answers so far */
    const ask = async (unknown) => {
      const answer = await app.api.get(`/exports?course=${id}`).catch(() => null);
      if (end.aborted) return;
      if (answer) course.value = answer;
      else if (unknown >= MOST_UNKNOWN) course.value = null;
      if (answer ? answer.state === "going on" : unknown < MOST_UNKNOWN)
        timer = setTimeout(ask, ASK_EVERY, answer ? unknown : unknown + 1);
    };
    course.value = "begun";
    timer = setTimeout(ask, ASK_EVERY, 0);
    return () => gone.abort();
  }, [id]);
  const now = course.value === "begun" ? null : course.value;
  return h(
    "div",
    { class: "measuring", hidden: course.value === null },
    h("p", { class: "number", role: "status" }, now ? courseWords(now) : course.value && t("export-begun")),
    h("progress", {
      max: 1,
      value: now?.recordings ? now.packed / now.recordings : 0,
      hidden: now !== null && now.state !== "going on",
      "aria-label": t("export-progress"),
    }),
  );
}

/** @param {ExportCourseView} course */
function courseWords({ packed, recordings, sent, state }) {
  return t(`export-state-${state}`, { packed, recordings, size: size(sent) });
}
