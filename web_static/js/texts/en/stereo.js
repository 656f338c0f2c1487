/** Texts of the stereo page. */
export default {
  "stereo.open": "Two eyes",
  "stereo.open.why":
    "The patient’s view in depth. On a paired screen, write stereo.html in place of patient.html in the address.",
  "stereo.open.link": "Open",
  "stereo.title": "bodydrive · stereo view",
  "stereo.settings": "How the two eyes see",
  "stereo.lost": "No connection to the program. The picture comes back by itself.",
  "stereo.waiting": "There is no picture at the moment. It comes by itself when a session goes on.",
  "stereo.refused.title": "This screen may not see the view yet",
  "stereo.refused.clinician": "Clinicians: sign in on this screen, then open this page again.",
  "stereo.refused.sign-in": "Sign in",
  "stereo.refused.patient":
    "Patient's screen: it is paired by a code from the clinician's page. Scan that first, then open this page again.",
  "stereo.mode": "Picture",
  "stereo.mode.side": "Side by side",
  "stereo.mode.squeezed": "Half width",
  "stereo.mode.red-cyan": "Red-cyan",
  "stereo.mode.side.why": "Each eye has half of the screen: for a phone in a holder, or two projectors.",
  "stereo.mode.squeezed.why":
    "Both pictures at half their width: for a projector or TV whose 3D setting is “side by side”.",
  "stereo.mode.red-cyan.why":
    "Both pictures in one, for glasses with red before the left eye and cyan before the right.",
  "stereo.apart": "Eye distance",
  "stereo.apart.why": "How far apart the eyes are. 63 mm is usual; less is calmer, 0 shows no depth.",
  "stereo.convergence": "Screen distance",
  "stereo.convergence.why": "What is this far away seems to lie on the screen; nearer things stand out of it.",
  "stereo.far": "Infinity",
  "stereo.swap.title": "Eyes",
  "stereo.swap": "Swap left and right",
  "stereo.swap.why": "If near things seem to lie behind far ones, the eyes are the wrong way round.",
  "stereo.split.title": "Split line",
  "stereo.split": "Show",
  "stereo.split.why": "A thin line between both pictures helps to centre a phone in its holder.",
  "stereo.full": "Full screen",
  "stereo.full.enter": "Full screen",
  "stereo.full.leave": "Leave full screen",
  "stereo.full.why": "The pictures reach the rims. These controls come back with a tap, a move or a key.",
  "stereo.comfort":
    "Comfort: begin with a small eye distance and raise it while it stays pleasant. If something looks double, choose another screen distance. If the eyes get tired or somebody feels unwell, set 0 mm or take a break.",
};
