/**
 * The large picture of a replay: in 3D, in a frame of its own server that shows nothing live, or as the drawn plan.
 * @import { App } from "../../main.js"
 * @import { FloorPlan, ReplayMoment, Timeline, TrialDetail } from "types/api"
 * @import { PlayHead } from "./play_head.js"
 * @typedef {NonNullable<ReplayMoment["view"]>} ViewIn3d
 */
import { ApiError, failureWords } from "../../api.js";
import { passFocus } from "../../focus.js";
import { newestWins } from "../../live/newest_wins.js";
import { replayDrawn } from "../../plan/replay_plan.js";
import { createRef, h, signal, useMemo, useRef, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { canDrawIn3d } from "../../view/webgl.js";
import { Segments } from "../../widgets/fields.js";
import { useUntilGone } from "../../widgets/made.js";

/** @type {ViewIn3d[]} */
const VIEWS_IN_3D = ["chase", "eye", "top"];
const PLAN = "plan";
const SEND_EVERY = 50; // ms
const AGAIN_EVERY = 2000; // ms: also a picture that has just come, or that was refused while somebody drove

/**
 * @param {{app: App, trial: TrialDetail, plan: FloorPlan | null, line: Timeline, head: PlayHead,
 *   left: AbortSignal}} picture plan: null where the place is not known
 */
export function ReplayView({ app, trial, plan, line, head, left }) {
  const has3d = useMemo(canDrawIn3d, []);
  const drawn = useMemo(() => plan && replayDrawn(plan, trial, line), []);
  const in3d = useMemo(() => replayIn3d(app, trial.id, head, left), []);
  const view = useSignal(/** @type {string} */ (has3d || !drawn ? VIEWS_IN_3D[0] : PLAN));
  const place = useRef(/** @type {HTMLDivElement | null} */ (null));
  const bar = useRef(/** @type {HTMLDivElement | null} */ (null));
  /** @param {string} chosen */
  const choose = (chosen) => {
    view.value = chosen;
    drawn?.setShown(chosen === PLAN);
    if (chosen !== PLAN && has3d) in3d.look(/** @type {ViewIn3d} */ (chosen));
  };
  useUntilGone(left, (gone) => {
    if (drawn) {
      // The drawn plan and its buttons are made by hand, and stand after what Preact draws here.
      place.current?.append(drawn.element);
      bar.current?.append(drawn.pad);
      head.follow(drawn.show, gone);
    }
    choose(view.value);
  });
  const views = drawn ? [...VIEWS_IN_3D, PLAN] : VIEWS_IN_3D;
  return h(
    "section",
    { class: "card replay-picture" },
    h("div", { class: "view replay-frame", ref: place }, h(PictureIn3d, { picture: in3d })),
    !has3d && h("p", { class: "no-view small", role: "status" }, t("replay-picture-webgl")),
    h(
      "div",
      { class: "spread", ref: bar },
      h(Segments, {
        label: t("trial-views"),
        options: views.map((value) => ({ value, label: t(`trial-view-${value}`) })),
        chosen: view.value,
        disabled: has3d ? [] : VIEWS_IN_3D,
        onChange: choose,
      }),
    ),
  );
}

/** @param {{picture: ReturnType<typeof replayIn3d>}} place */
function PictureIn3d({ picture: { frame, address, state, open, show } }) {
  const { message, isOff, isClosed } = state.value;
  return h(
    "div",
    { class: isOff ? "in-3d off" : "in-3d" },
    h("iframe", {
      title: t("replay-picture"),
      tabindex: -1,
      src: address.value || undefined,
      ref: frame,
      onLoad: show,
    }),
    h(
      "p",
      { class: "over-picture", role: "status" },
      message,
      isClosed && [
        " ",
        h("button", { type: "button", class: "btn small", ref: passFocus, onClick: open }, t("replay-picture-again")),
      ],
    ),
  );
}

/**
 * The 3D picture; its server is opened with the first look.
 * @param {App} app @param {number} trial id @param {PlayHead} head @param {AbortSignal} left
 */
function replayIn3d(app, trial, head, left) {
  const frame = /** @type {{current: HTMLIFrameElement | null}} */ (createRef());
  const address = signal("");
  /** The message over the picture; isClosed: the server has closed the replay, and a person may open another one. */
  const state = signal({ message: t("replay-picture-loading"), isOff: false, isClosed: false });
  let id = ""; // of the replay that is open
  /** @type {ReplayMoment["view"] | null} */
  let view = null;
  let isOpening = false;
  const open = async () => {
    isOpening = true;
    try {
      const { id: opened } = await app.api.post("/replays", { trial });
      if (left.aborted) return close(opened);
      id = opened;
      address.value = `/view/replay/${id}/`;
    } catch (error) {
      refused(error);
    } finally {
      isOpening = false;
    }
  };
  /** @param {string} opened id */
  const close = (opened) => app.api.remove(`/replays/${opened}`).catch(() => {});
  /** @param {string} why @param {boolean} [isClosed] */
  const turnOff = (why, isClosed = false) =>
    void (state.value = { message: t("replay-picture-off", { why }), isOff: true, isClosed });
  /** @param {unknown} error */
  const refused = (error) => {
    const isClosed = error instanceof ApiError && error.status === 404 && id !== "";
    if (isClosed) id = "";
    turnOff(failureWords(error), isClosed);
  };
  const isDrawn = () => frame.current?.contentWindow?.bodydriveView?.draws() ?? true;
  const send = newestWins(async (/** @type {ReplayMoment} */ moment) => {
    if (!id || left.aborted) return;
    try {
      await app.api.post(`/replays/${id}/at`, moment);
      if (!isDrawn()) return turnOff(t("replay-picture-context"));
      state.value = { message: "", isOff: false, isClosed: false };
    } catch (error) {
      refused(error);
    }
  }, SEND_EVERY);
  const show = () => void (view && send({ t: Number(head.t.toFixed(3)), view }));
  head.follow(show, left);
  const timer = setInterval(() => {
    if (!view || document.visibilityState !== "visible" || head.isPlaying.value) return;
    if (id) show();
    else if (state.value.isOff && !state.value.isClosed) open();
  }, AGAIN_EVERY);
  left.addEventListener("abort", () => {
    clearInterval(timer);
    if (id) close(id);
  });
  /** @param {ViewIn3d} from where to look from */
  const look = (from) => {
    view = from;
    if (!id && !isOpening) open();
    else show();
  };
  return { frame, address, state, open, show, look };
}
