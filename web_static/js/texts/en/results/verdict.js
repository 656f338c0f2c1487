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
    "This is one of the first three trials of this task on its day. They are for getting used to the task and are not compared.",
  "verdict.means":
    "Noise is how much this person's own trials of this task differ without a change. A verdict needs five trials of the task in all, and from one session to the next also earlier sessions, or three other people of the clinic who did the task.",
  "verdict.chance": "Where nothing changed, about one verdict in thirty says better or worse by chance.",
  "verdict.unpublished":
    "No minimal detectable change has been published for these measures of wheelchair driving.",
  "verdict.sessions": "Session {later} ({second}) against session {earlier} ({first})",
  "verdict.trials": { one: "{count} trial", other: "{count} trials" },
  "verdict.session": "Session {number}",
  "verdict.all": "All measures",
  "verdict.counts": {
    one: "{count} of the {all} trials of this task can be compared: the first three of a day are for getting used to it, and the goal has to be reached.",
    other: "{count} of the {all} trials of this task can be compared: the first three of a day are for getting used to it, and the goal has to be reached.",
  },
  "verdict.counts.none":
    "No trial of this task can be compared yet ({all} driven): the first three of a day are for getting used to it, and the goal has to be reached.",
  "verdict.needed": "A verdict needs {count} that can be compared, from two sessions together: drive this task more than three times in each.",
  "verdict.few": { one: "{count} trial can be compared so far, {needed} are needed.", other: "{count} trials can be compared so far, {needed} are needed." },
  "verdict.few.sessions":
    "{count} trials can be compared, which is enough; to compare sessions, one more session is needed, or three other people of the clinic who did this task.",
  "verdict.compare": "Compare sessions",
};
