/** Texts of the review of one trial and of two side by side. */
export default {
  "compare.column": "Compare",
  "compare.pick": "Compare trial {number}",
  "compare.go": "Compare two trials",
  "compare.chosen": "Trial {first} and trial {second} are chosen.",
  "compare.choose": { one: "Tick one more trial.", other: "Tick two trials of the list." },
  "compare.title": "Two trials side by side",
  "compare.trial": "Trial {number}",
  "compare.difference": "Difference",
  "compare.measures": "Measures",
  "compare.better": "Better",
  "compare.no-measures": "Neither of the two was measured.",
};
