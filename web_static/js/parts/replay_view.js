/** A replay in 3D, in a frame of its own server: "Replay" stands on the picture, and nobody's live picture changes. */
import { t } from "../texts.js";
import { h, put, write } from "./dom.js";
import { segments } from "./fields.js";
import { newestWins } from "./newest_wins.js";

const VIEWS = ["chase", "eye", "top"];
const SEND_EVERY = 50; // ms
const AGAIN_EVERY = 2000; // ms: also a picture that has just come, or that was refused while somebody drove

/**
 * @param {import("../main.js").App} app @param {number} trial id
 * @param {import("./play_head.js").PlayHead} head @param {AbortSignal} signal
 */
export function replayView(app, trial, head, signal) {
  const words = h("p", { class: "over-picture", role: "status" }, t("replay.picture.loading"));
  const frame = h("iframe", { title: t("replay.picture"), tabindex: "-1" });
  const place = h("div", { class: "view replay-frame" }, frame, words);
  let word = "";
  let view = VIEWS[0];
  const isLeft = () => signal.aborted;
  const open = async () => {
    try {
      const { id } = await app.api.post("/replays", { trial });
      if (isLeft()) return close(id);
      word = id;
      frame.src = `/view/replay/${id}/`;
    } catch (error) {
      refused(error);
    }
  };
  const close = (id) => app.api.remove(`/replays/${id}`).catch(() => {});
  const refused = (error) => {
    write(words, t("replay.picture.off", { why: error.message }));
    place.classList.add("off");
    // A replay that was closed meanwhile is opened anew.
    if (error.status === 404 && word) {
      word = "";
      put(words, t("replay.picture.off", { why: error.message }), " ", again);
    }
  };
  const again = h("button", { type: "button", class: "btn small", onclick: open }, t("replay.picture.again"));
  const send = newestWins(async (moment) => {
    if (!word || isLeft()) return;
    try {
      await app.api.post(`/replays/${word}/at`, moment);
      write(words, "");
      place.classList.remove("off");
    } catch (error) {
      refused(error);
    }
  }, SEND_EVERY);
  const show = () => send({ t: Number(head.t.toFixed(3)), view });
  frame.addEventListener("load", show);
  head.addEventListener("time", show, { signal });
  const timer = setInterval(() => {
    if (document.visibilityState !== "visible" || head.playing) return;
    if (word) show();
    else if (place.classList.contains("off") && !again.isConnected) open();
  }, AGAIN_EVERY);
  signal.addEventListener("abort", () => {
    clearInterval(timer);
    if (word) close(word);
  });
  open();
  const views = segments(
    t("trial.views"),
    VIEWS.map((value) => ({ value, label: t(`trial.view.${value}`) })),
    view,
    (chosen) => {
      view = chosen;
      show();
    },
  );
  return h("section", { class: "card replay-picture" }, place, views);
}
