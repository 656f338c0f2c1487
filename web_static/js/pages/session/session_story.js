/** A session as a story for people who sign in: `#/session/story/ID`. Its trials lead to their replays. */
import { newestAnswer } from "../../live/newest_answer.js";
import { Fragment, h } from "../../preact.js";
import { Story } from "../../results/story.js";
import { t } from "../../texts.js";
import { drawWithLinks } from "./frame.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal: left, rest: [, session] }) {
  const id = Number(session);
  const ask = () => app.api.get(`/sessions/${id}/story`);
  const first = await ask();
  if (left.aborted) return;
  const { number, code, patient_id: patient } = first;
  app.setSubject({ patient, code, sessions: [number] });
  const story = newestAnswer(app, left, first, ask, { what: ["record", "comment", "trial", "session"], session: id });
  const Card = () =>
    h(
      "section",
      { class: "card stack" },
      h(Story, { story: story.value, replay: (trial) => `#/review/${patient}/trial/${trial}` }),
    );
  const heading = h("h1", { tabindex: -1 }, t("record-story-title", { number, code }));
  drawWithLinks(root, h(Fragment, {}, heading, h(Card, {})), {
    [`#/session/${id}`]: t("record-story-record"),
    [`#/session/patient/${patient}`]: t("record-back"),
  });
}
