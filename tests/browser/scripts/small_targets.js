// Controls with less than 44 px of touch area, within what a selector finds.
(within) => {
  const targets = "button, a[href], input:not([type=file]), select, textarea, summary, [role=slider]";
  const name = (one) => `${one.tagName.toLowerCase()}.${one.getAttribute("class") ?? ""} "${
    (one.getAttribute("aria-label") ?? one.textContent).trim().slice(0, 40)}"`;
  const isShown = (one) => one.checkVisibility({ visibilityProperty: true, opacityProperty: true });
  return [...document.querySelectorAll(targets)]
    .filter((one) => one.closest(within) && isShown(one) && !one.closest(".unseen"))
    .map((one) => one.closest("label") ?? one)
    .filter((one) => !(one.matches("a:not(.btn)") && one.closest("p, li, td")))
    .map((one) => [one, one.getBoundingClientRect()])
    .filter(([one, { width, height }]) => width && (height < 43.5 || (width < 43.5 && !one.matches("[role=slider]"))))
    .map(([one, { width, height }]) => `${Math.round(width)} x ${Math.round(height)} ${name(one)}`);
}
