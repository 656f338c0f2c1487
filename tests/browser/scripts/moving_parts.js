// What moves after everything that opens was turned over, and every switch was pressed.
() => {
  document.querySelectorAll("details").forEach((one) => (one.open = !one.open));
  document.querySelectorAll(".switch input").forEach((one) => (one.checked = !one.checked));
  document.querySelectorAll(".tune").forEach((one) => one.setAttribute("aria-expanded", "true"));
  getComputedStyle(document.body).opacity;
  return document.getAnimations({ subtree: true }).map(({ effect, animationName, transitionProperty }) =>
    `${animationName ?? transitionProperty} of ${effect.target.className} ${effect.pseudoElement ?? ""}`);
}
