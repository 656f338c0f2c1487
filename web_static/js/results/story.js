/**
 * A session as a story: what was done, what changed and what was said. For people who sign in, and for a share link.
 * @import { StoryView, EventView } from "types/api"
 * @typedef {(trial: number) => string} ReplayAddress address of the replay of a trial
 */
import { Fragment, h } from "../preact.js";
import { t, hasText } from "../texts.js";
import { day, minuteOfDay, number } from "../widgets/format.js";
import { interruptionWords } from "./interruptions.js";
import { originWords } from "./origin_words.js";

const SAID = ["note", "comment", "unlock"]; // kinds of events with words of a person

/**
 * What stands below the heading of a story.
 * @param {{story: StoryView, replay?: ReplayAddress}} story replay: a share link opens none
 */
export function Story({ story: { goal, scales, is_signed: isSigned, origin, events }, replay }) {
  return h(
    Fragment,
    {},
    h("p", { class: "quiet" }, t(isSigned ? "share-signed" : "share-unsigned")),
    origin && h("p", { class: "quiet" }, originWords(origin)),
    goal && h("p", { class: "own-words" }, `${t("share-goal")}: ${goal}`),
    scales.length > 0 &&
      h(
        "p",
        {},
        scales.map(({ name, total }) => `${name}: ${number(total, Number.isInteger(total) ? 0 : 1)}`).join(" · "),
      ),
    h(
      "ol",
      { class: "story" },
      events.map((event, i) =>
        h(EventLine, {
          key: `${event.kind} ${event.at}`,
          event,
          replay,
          isNewDay: day(event.at) !== day(events[i - 1]?.at ?? null),
        }),
      ),
    ),
  );
}

/** @param {{event: EventView, replay?: ReplayAddress, isNewDay: boolean}} line */
function EventLine({ event: { at, kind, person, text, facts }, replay, isNewDay }) {
  const end = hasText(`review-end-${facts.end}`) ? t(`review-end-${facts.end}`) : "";
  const seconds = typeof facts.t === "number" ? number(facts.t, 1) : "";
  const title = t(`share-event-${kind}`, { ...facts, count: Number(facts.recordings), t: seconds, text, end });
  const trial = kind === "trial" ? facts.id : facts.trial;
  const marks = [
    interruptionWords(facts),
    hasText(`share-source-${facts.source}`) && t(`share-source-${facts.source}`),
    facts.kept === false && t("record-driven-discarded", { reason: String(facts.discard_reason ?? "") }),
  ].filter(Boolean);
  return h(
    "li",
    {},
    h("time", { datetime: at }, minuteOfDay(at)),
    h(
      "div",
      {},
      isNewDay && h("div", { class: "quiet small" }, day(at)),
      replay && trial ? h("a", { class: "row-link", href: replay(Number(trial)) }, title) : title,
      person && h("span", { class: "quiet" }, ` · ${person}`),
      marks.length > 0 && h("div", { class: "quiet small" }, marks.join(", ")),
      SAID.includes(kind) && text && h("p", { class: "own-words" }, text),
    ),
  );
}
