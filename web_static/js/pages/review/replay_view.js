/**
 * The large picture of a replay: in 3D, in a frame of its own server that shows nothing live, or as the drawn plan.
 * @import { App } from "../../main.js"
 * @import { ReplayMoment } from "types/api"
 * @import { Child } from "types/dom"
 * @import { PlayHead } from "./play_head.js"
 * @typedef {ReplayMoment["view"] | "plan"} View
 */
import { ApiError, failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, put, write } from "../../widgets/dom.js";
import { segments } from "../../widgets/fields.js";
import { newestWins } from "../../live/newest_wins.js";
import { canDrawIn3d } from "../../view/webgl.js";

/** @type {NonNullable<ReplayMoment["view"]>[]} */
const VIEWS_IN_3D = ["chase", "eye", "top"];
const SEND_EVERY = 50; // ms
const AGAIN_EVERY = 2000; // ms: also a picture that has just come, or that was refused while somebody drove

/**
 * @param {App} app @param {number} trial id
 * @param {ReturnType<import("../../plan/replay_plan.js").replayDrawn> | null} drawn the drawn plan; null where the place is not known
 * @param {PlayHead} head @param {AbortSignal} signal
 */
export function replayView(app, trial, drawn, head, signal) {
  const has3d = canDrawIn3d();
  const first = has3d || !drawn ? VIEWS_IN_3D[0] : "plan";
  const in3d = replayIn3d(app, trial, head, signal);
  const place = h("div", { class: "view replay-frame" }, in3d.element, drawn?.element);
  /** @param {View} view */
  const choose = (view) => {
    drawn?.setShown(view === "plan");
    if (view !== "plan" && has3d) in3d.look(view);
  };
  const showDrawn = () => drawn?.show(head.t);
  head.addEventListener("time", showDrawn, { signal });
  showDrawn();
  choose(first);
  /** @type {NonNullable<View>[]} */
  const offered = drawn ? [...VIEWS_IN_3D, "plan"] : VIEWS_IN_3D;
  const views = segments(
    t("trial-views"),
    offered.map((value) => ({ value, label: t(`trial-view-${value}`) })),
    first,
    choose,
  );
  if (!has3d) for (const radio of views.querySelectorAll("input")) radio.disabled = radio.value !== "plan";
  const why = !has3d && h("p", { class: "no-view small", role: "status" }, t("replay-picture-webgl"));
  const bar = h("div", { class: "spread" }, views, drawn?.pad);
  return h("section", { class: "card replay-picture" }, place, why, bar);
}

/**
 * The 3D picture; its server is opened with the first look.
 * @param {App} app @param {number} trial id @param {PlayHead} head @param {AbortSignal} signal
 */
function replayIn3d(app, trial, head, signal) {
  const words = h("p", { class: "over-picture", role: "status" }, t("replay-picture-loading"));
  const frame = h("iframe", { title: t("replay-picture"), tabindex: "-1" });
  const element = h("div", { class: "in-3d" }, frame, words);
  let word = "";
  /** @type {ReplayMoment["view"] | null} */
  let view = null;
  let isOpening = false;
  const isLeft = () => signal.aborted;
  const open = async () => {
    isOpening = true;
    try {
      const { id } = await app.api.post("/replays", { trial });
      if (isLeft()) return close(id);
      word = id;
      frame.src = `/view/replay/${id}/`;
    } catch (error) {
      refused(error);
    } finally {
      isOpening = false;
    }
  };
  /** @param {string} id */
  const close = (id) => app.api.remove(`/replays/${id}`).catch(() => {});
  /** @param {string} why @param {...Child} more */
  const off = (why, ...more) => {
    element.classList.add("off");
    put(words, t("replay-picture-off", { why }), ...more);
  };
  /** @param {unknown} error */
  const refused = (error) => {
    off(failureWords(error));
    // A replay that was closed meanwhile is opened anew.
    if (error instanceof ApiError && error.status === 404 && word) {
      word = "";
      off(failureWords(error), " ", again);
    }
  };
  const again = h("button", { type: "button", class: "btn small", onclick: open }, t("replay-picture-again"));
  const isDrawn = () => frame.contentWindow?.bodydriveView?.draws() ?? true;
  const send = newestWins(async (/** @type {ReplayMoment} */ moment) => {
    if (!word || isLeft()) return;
    try {
      await app.api.post(`/replays/${word}/at`, moment);
      if (!isDrawn()) return off(t("replay-picture-context"));
      write(words, "");
      element.classList.remove("off");
    } catch (error) {
      refused(error);
    }
  }, SEND_EVERY);
  const show = () => view && send({ t: Number(head.t.toFixed(3)), view });
  frame.addEventListener("load", show);
  head.addEventListener("time", show, { signal });
  const timer = setInterval(() => {
    if (!view || document.visibilityState !== "visible" || head.playing) return;
    if (word) show();
    else if (element.classList.contains("off") && !again.isConnected) open();
  }, AGAIN_EVERY);
  signal.addEventListener("abort", () => {
    clearInterval(timer);
    if (word) close(word);
  });
  /** @param {ReplayMoment["view"]} from where to look from */
  const look = (from) => {
    view = from;
    if (!word && !isOpening) open();
    else show();
  };
  return { element, look };
}
