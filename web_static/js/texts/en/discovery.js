/** Texts of the movements that were found in a calibration. */
export default {
  "found.title": "Every movement this body can make",
  "found.lead":
    "Best first. The score weighs the four columns after it, 100 would be perfect; what keeps a movement back is marked.",
  "found.take": "Put these into the controls",
  "found.take.later": "Use this calibration first; then one tap in Controls takes the suggestion.",
  "found.gesture": "Movement",
  "found.score": "Score",
  "found.signal_to_noise": "Signal",
  "found.repeatability": "Repeats",
  "found.cross_talk": "Moves along with it",
  "found.effort": "Effort",
  "found.false": "False at rest",
  "found.hits": "Answered",
  "found.means.score": "50 stands at the limits of a usable joint on average, 100 would be perfect",
  "found.means.signal_to_noise": "How far a full movement stands above the noise at rest",
  "found.means.repeatability": "How far the peaks of the repetitions differ",
  "found.means.cross_talk": "How much it appears with another movement, or another with it",
  "found.means.effort": "Share of the joint's span to move for full effect; counted twice for a way back",
  "found.means.false": "How often a minute it is expected to act at rest",
  "found.means.hits": "Share of movements that should reach half of full",
  "found.details": "Details",
  "found.details.one": "{gesture}: signal to noise {signal}, repetitions within {repeats}.",
  "found.weakest": "This keeps it back most",
  "found.less": "under {value}",
  "found.check": "How sure is that?",
  "found.check.lead":
    "Each forecast was made from one part of the recordings and checked on the rest. So few repetitions prove little: the last numbers say how little.",
  "found.check.rest":
    "Forecast from the first rest: it acts {predicted} times a minute. Counted in another {seconds} s: {counted}. All {all} s together prove fewer than {bound} a minute (95 %).",
  "found.check.hits":
    "Forecast: {predicted} of the movements answered. Counted, each left out in turn: {counted} of {all}, so at least {bound} (95 %).",
};
