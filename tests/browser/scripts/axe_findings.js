// What axe-core finds on the page, or on what a selector finds: violations, and contrast that it could not decide.
(context) => {
  const contrast = {
    ignoreUnicode: false, ignoreLength: true, ignorePseudo: false, boldValue: 700, boldTextPt: 14, largeTextPt: 18,
    contrastRatio: { normal: { expected: 4.5 }, large: { expected: 3 } },
    pseudoSizeThreshold: 0.25, shadowOutlineEmMax: 0.2, textStrokeEmMin: 0.03,
  };
  axe.configure({ checks: [{ id: "color-contrast", options: contrast }] });
  const only = context && { runOnly: ["color-contrast"] };
  // In forced colours the browser paints text and what is behind it in colours of the person's own choice.
  const isForced = matchMedia("(forced-colors: active)").matches;
  const element = context && document.querySelector(context);
  if (context && !element) return [];
  element?.scrollIntoView({ block: "center", inline: "center", behavior: "instant" });
  // The foot of a page sticks to its lower edge: at the very end, nothing of the page lies behind it.
  element?.closest(".foot")?.parentElement.scrollTo({ top: 1e6, behavior: "instant" });
  // Nothing shows through a dialog whose background is solid, but axe counts what lies behind it.
  const dialog = element?.closest("[role=dialog]");
  const isSolid = dialog && /^rgb\(/.test(getComputedStyle(dialog).backgroundColor);
  const behind = isSolid ? [...document.querySelectorAll("main")].filter((one) => !one.contains(dialog)) : [];
  // A drawing shows nothing beyond its box, but axe counts what the box cuts off.
  const box = element?.getBoundingClientRect();
  for (const drawing of box ? document.querySelectorAll("svg") : []) {
    const { left, right, top, bottom } = drawing.getBoundingClientRect();
    const isApart = left >= box.right || right <= box.left || top >= box.bottom || bottom <= box.top;
    if (isApart && getComputedStyle(drawing).overflow === "hidden") behind.push(drawing);
  }
  for (const one of behind) one.style.visibility = "hidden";
  return axe.run(element ?? document, {
    iframes: false,
    resultTypes: ["violations", "incomplete"],
    ...(only ?? { rules: {
      "target-size": { enabled: true },
      "label-content-name-mismatch": { enabled: true }, // who says "click All" by voice says what is written
      "color-contrast": { enabled: !isForced },
    } }),
  }).then(({ violations, incomplete }) => {
    const rows = (kind, rules) => rules.flatMap(({ id, impact, nodes }) => nodes.map((node) => ({
      kind, rule: id, impact, target: node.target.join(" "), html: node.html.slice(0, 140),
      why: [...node.any, ...node.all, ...node.none].map(({ message }) => message).join(" ").slice(0, 200),
    })));
    const undecided = rows("undecided", incomplete)
      .filter(({ rule, why }) => rule === "color-contrast" || why.includes("encountered an error"));
    return [...rows("violation", violations), ...undecided];
  }).finally(() => { for (const one of behind) one.style.visibility = ""; });
}
