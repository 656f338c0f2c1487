/** Texts of the verdicts on changes. */
export default {
  "verdict.better": "better than noise",
  "verdict.within": "within noise",
  "verdict.worse": "worse than noise",
  "verdict.too few": "too few trials",
  "verdict.range": "{low} to {high}",
  "verdict.title": "Better, or noise?",
  "verdict.column": "Verdict",
  "verdict.noise": "Within noise",
  "verdict.familiarisation":
    "This is one of the first three trials of this task on its day. They count as getting used to the task and are not compared.",
  "verdict.means":
    "Noise is how much this person's own trials of this task differ without a change. A verdict needs five trials of the task, and from one session to the next also earlier sessions, or three other people of the clinic who did the task.",
  "verdict.chance": "Where nothing changed, about one verdict in thirty says better or worse by chance.",
  "verdict.unpublished":
    "No minimal detectable change has been published for these measures of wheelchair driving.",
  "verdict.sessions": "Session {later} ({second}) against session {earlier} ({first})",
  "verdict.trials": { one: "{count} trial", other: "{count} trials" },
  "verdict.session": "Session {number}",
  "verdict.all": "All measures",
  "verdict.none":
    "When this task has been driven in two sessions, with more than three trials in each, the newest session is compared here with the one before.",
};
