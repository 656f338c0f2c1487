/** A session as a story for people who sign in: `#/session/story/ID`. Its trials lead to their replays. */
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { storyParts } from "../../results/story.js";

const CHANGES = ["record", "trial", "session", "everything"];

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal, rest: [, session] }) {
  const id = Number(session);
  let story = await app.api.get(`/sessions/${id}/story`);
  if (signal.aborted) return;
  const { number, code, patient_id: patient } = story;
  app.setSubject({ code, sessions: [number] });
  const card = h("section", { class: "card stack" });
  const draw = () =>
    put(
      card,
      storyParts(story, (trial) => `#/review/${patient}/trial/${trial}`),
    );
  /** @param {CustomEvent<string>} event */
  const read = async ({ detail }) => {
    if (!CHANGES.includes(detail)) return;
    const now = await app.api.get(`/sessions/${id}/story`).catch(() => story);
    if (signal.aborted || card.contains(document.activeElement) || JSON.stringify(now) === JSON.stringify(story))
      return;
    story = now;
    draw();
  };
  app.live.addEventListener("changed", read, { signal });
  draw();
  put(
    root,
    h(
      "div",
      { class: "body session-record" },
      h("h1", { tabindex: "-1" }, t("record-story-title", { number, code })),
      card,
    ),
    h(
      "div",
      { class: "foot" },
      h("span", { class: "grow" }),
      h("a", { class: "btn", href: `#/session/${id}` }, t("record-story-record")),
      h("a", { class: "btn", href: `#/session/patient/${patient}` }, t("record-back")),
    ),
  );
}
