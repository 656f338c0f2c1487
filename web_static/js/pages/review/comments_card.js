/**
 * The comments on moments of a trial, beside its replay: each leads to its moment, and its author can change it.
 * @import { CommentView } from "types/api"
 * @import { PlayHead } from "./play_head.js"
 */
import { limitsOf } from "../../reference.js";
import { t } from "../../texts.js";
import { h, put, set } from "../../widgets/dom.js";
import { moment, number } from "../../widgets/format.js";
import { textForm } from "../../widgets/fields.js";

const NEAR = 0.05; // s from the moment that the replay shows

/**
 * @param {import("../../main.js").App} app @param {number} trial id @param {CommentView[]} comments
 * @param {PlayHead | null} head null: there is no replay, so comments can only be read
 * @param {AbortSignal} signal
 * @returns {{element: HTMLElement, marks: HTMLElement}} marks: for the time bar
 */
export function commentsCard(app, trial, comments, head, signal) {
  const heading = h("h2", { tabindex: "-1" }, t("comments-title"));
  const none = h("p", { class: "quiet" }, t("comments-none"));
  const list = h("ol", { class: "comments" });
  const place = h("div", {});
  const marks = h("div", { class: "event-marks comment-marks", "aria-hidden": "true" });
  /** @type {Set<number>} those that were unread when this page first showed them */
  const fresh = new Set();
  /** @param {() => Promise<CommentView[]>} act @param {string} words to say when it is done */
  const change = async (act, words) => {
    const now = await app.toasts.attempt(act);
    if (!now || signal.aborted) return false;
    comments = now;
    draw();
    app.toasts.show(words);
    return true;
  };
  /** @param {CommentView} comment */
  const row = (comment) => {
    const { id, person, is_own: isOwn, t: at, revisions } = comment;
    const [newest, ...earlier] = revisions;
    const values = { t: number(at, 1), person };
    const element = h("li", { "data-t": at });
    /** @param {MouseEvent} event */
    const go = ({ detail: taps }) => {
      head?.pause();
      head?.seek(at);
      if (taps > 0) showPicture(); // somebody with a keyboard keeps the focus in sight instead
    };
    const revise = () => {
      put(element, revision(comment));
      element.querySelector("textarea")?.focus();
    };
    return put(
      element,
      h(
        "div",
        { class: "spread" },
        head
          ? h(
              "button",
              { type: "button", class: "btn bare small moment", "aria-label": t("comments-go", values), onclick: go },
              t("comments-at", values),
            )
          : h("b", {}, t("comments-at", values)),
        h(
          "span",
          { class: "quiet small grow" },
          t(earlier.length ? "comments-by-revised" : "comments-by", { person, moment: moment(newest.written) }),
        ),
        fresh.has(id) && h("span", { class: "tag att" }, t("comments-new")),
      ),
      h("p", { class: "own-words" }, newest.text),
      isOwn &&
        h(
          "button",
          {
            type: "button",
            class: "btn bare small",
            "data-comment": id,
            "aria-label": t("comments-change-label", values),
            onclick: revise,
          },
          t("comments-change"),
        ),
      earlier.length > 0 &&
        h(
          "details",
          {},
          h("summary", {}, t("comments-history", { count: earlier.length })),
          earlier.map(({ text, written }) =>
            h(
              "div",
              { class: "earlier-text" },
              h("p", { class: "own-words" }, text),
              h("p", { class: "quiet small" }, moment(written)),
            ),
          ),
        ),
    );
  };
  /** @param {CommentView} comment */
  const revision = ({ id, t: at, revisions }) => {
    const again = () => /** @type {HTMLElement | null} */ (list.querySelector(`[data-comment="${id}"]`))?.focus();
    const withdraw = async () => {
      if (await change(() => app.api.remove(`/comments/${id}`), t("comments-withdrawn"))) heading.focus();
    };
    return textForm({
      label: t("comments-text", { t: number(at, 1) }),
      text: revisions[0].text,
      action: t("comments-save"),
      longest: limitsOf("NewComment", "text").longest ?? Infinity,
      send: async (text) =>
        (await change(() => app.api.put(`/comments/${id}`, { text }), t("comments-revised"))) && again(),
      onClose: () => {
        draw();
        again();
      },
      more: h("button", { type: "button", class: "btn", onclick: withdraw }, t("comments-withdraw")),
    });
  };
  /** A form to write at the moment that the replay shows, which it then shows still. */
  const offer = () => {
    const write = h("button", { type: "button", class: "btn small" }, t("comments-write"));
    const close = () => {
      offer();
      place.querySelector("button")?.focus();
    };
    write.addEventListener("click", () => {
      const { t: at } = /** @type {PlayHead} */ (head);
      head?.pause();
      put(
        place,
        textForm({
          label: t("comments-text", { t: number(at, 1) }),
          hint: t("comments-hint"),
          action: t("comments-add"),
          longest: limitsOf("NewComment", "text").longest ?? Infinity,
          send: async (text) =>
            (await change(() => app.api.post(`/trials/${trial}/comments`, { t: at, text }), t("comments-added"))) &&
            close(),
          onClose: close,
        }),
      );
      place.querySelector("textarea")?.focus();
      place.scrollIntoView({ block: "nearest" });
    });
    put(place, write);
  };
  const showHere = () => {
    for (const one of list.children) {
      const isHere = Math.abs(Number(/** @type {HTMLElement} */ (one).dataset.t) - Number(head?.t)) < NEAR;
      one.classList.toggle("is-here", isHere);
      const button = one.querySelector(".moment");
      if (button) set(button, { "aria-current": isHere ? "true" : null });
    }
  };
  const draw = () => {
    for (const { id, unread } of comments) if (unread) fresh.add(id);
    put(list, comments.map(row));
    list.hidden = !comments.length;
    none.hidden = comments.length > 0;
    if (head)
      put(
        marks,
        comments.map(({ t: at }) => h("i", { style: `left: ${head.share(at)}%` })),
      );
    showHere();
    if (comments.some(({ unread }) => unread)) app.api.post(`/trials/${trial}/comments/read`).catch(() => {});
  };
  /** @param {CustomEvent<string>} event */
  const read = async ({ detail }) => {
    if (detail !== "record" && detail !== "everything") return;
    const now = await app.api.get(`/trials/${trial}/comments`).catch(() => comments);
    const isRevised = list.querySelector("form") !== null; // what is being written stays
    if (signal.aborted || isRevised || shownOf(now) === shownOf(comments)) return;
    comments = now;
    draw();
  };
  app.live.addEventListener("changed", read, { signal });
  head?.addEventListener("time", showHere, { signal });
  draw();
  if (head) offer();
  else if (comments.length) put(place, h("p", { class: "quiet small" }, t("comments-lost")));
  return { element: h("section", { class: "card stack comments-card" }, heading, none, list, place), marks };
}

/** What is shown of comments, as one text: one that has just been read keeps its mark here. @param {CommentView[]} comments */
const shownOf = (comments) => JSON.stringify(comments, (name, value) => (name === "unread" ? null : value));

/** Scroll back to the picture: on a phone the list stands far below it. */
function showPicture() {
  const picture = document.querySelector(".replay-picture");
  const page = picture?.closest("main");
  if (picture && page && picture.getBoundingClientRect().top < page.getBoundingClientRect().top - 1)
    picture.scrollIntoView();
}
