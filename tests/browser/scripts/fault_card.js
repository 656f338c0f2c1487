// A card over the picture, outside every page: one and the same fault, with a picture or none.
() => import("/js/widgets/trial_cue.js").then(({ trialCue }) => {
  const picture = { shows: "view", why: "" };
  const app = { live: { latest: null }, halt: (fault) => ({ ...fault, key: fault.name, again: "" }) };
  const { element, show } = trialCue(app, picture, () => {}, () => {});
  document.body.append(element);
  const fault = { name: "shirt_silent", happened: "The shirt is silent.", next_step: "Look at its cable.", remedy: "" };
  window.showFault = (why) => {
    Object.assign(picture, { shows: why ? "none" : "view", why });
    show({ control: "alive", state: "fault", fault, stops: 0, trial: { waits: 300 } });
    return element.textContent;
  };
  window.removeCard = () => element.remove();
})
