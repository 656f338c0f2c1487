// Notes everything that gets the focus: whether the focus is seen, and whether something lies over it.
() => {
  const name = (one) => `${one.tagName.toLowerCase()}.${one.getAttribute("class") ?? ""} "${
    (one.getAttribute("aria-label") ?? one.labels?.[0]?.textContent ?? one.textContent).trim().slice(0, 40)}"`;
  const every = "a[href], button, input, select, textarea, summary, iframe, [tabindex]";
  const groups = new Map();
  const wanted = [...document.querySelectorAll(every)].filter((one) => {
    if (!one.checkVisibility({ visibilityProperty: true }) || one.disabled || one.tabIndex < 0) return false;
    if (one.closest("[inert]") || one.localName === "iframe") return false;
    if (one.type !== "radio" || !one.name) return true;
    const key = `${one.name} ${one.form ? [...document.forms].indexOf(one.form) : ""}`;
    const group = groups.get(key) ?? [...document.querySelectorAll("input[type=radio]")]
      .filter((other) => other.name === one.name && other.form === one.form);
    groups.set(key, group);
    return one === (group.find((other) => other.checked) ?? group[0]);
  });
  const faults = wanted.filter((one) => one.tabIndex > 0).map((one) => `before its turn: ${name(one)}`);
  const reached = [];
  const isSeen = (one) => [one, one.closest("label"), one.nextElementSibling, one.querySelector("*")]
    .some((each) => {
      if (!each) return false;
      const { outlineStyle, outlineWidth } = getComputedStyle(each);
      return outlineStyle !== "none" && parseFloat(outlineWidth) > 0;
    }) || one.localName === "g";
  const isCovered = (one) => {
    const box = (one.closest("label") ?? one).getBoundingClientRect();
    const places = [0.5, 0.05, 0.95].map((part) => [box.left + part * box.width, box.top + part * box.height]);
    return !places.some(([x, y]) => {
      const at = document.elementFromPoint(x, y);
      const isPassing = at?.closest(".toast, .question"); // it goes away by itself, or is answered first
      return at && (isPassing || one.contains(at) || at.contains(one) || at.closest("label")?.contains(one));
    });
  };
  const listen = ({ target }) => {
    if (target === start || target.tabIndex < 0) return; // focused by the page itself: no stop of Tab
    reached.push(target);
    if (!isSeen(target)) faults.push(`its focus is not seen: ${name(target)}`);
    if (isCovered(target)) faults.push(`covered: ${name(target)}`);
  };
  document.addEventListener("focusin", listen, true);
  const start = document.createElement("span"); // Tab begins after the element that had the focus
  start.tabIndex = -1;
  document.body.prepend(start);
  start.focus();
  const unreached = () => wanted.filter((one) =>
    one.isConnected && one.checkVisibility() && !one.disabled && one.tabIndex >= 0 && !reached.includes(one));
  window.isSwept = () => unreached().length === 0;
  window.endSweep = () => {
    document.removeEventListener("focusin", listen, true);
    start.remove();
    for (const one of unreached()) faults.push(`Tab does not come to ${name(one)}`);
    const places = reached.map((one) => wanted.indexOf(one)).filter((place) => place >= 0);
    places.forEach((place, i) => {
      if (i && place <= places[i - 1] && place) faults.push(`Tab goes back to ${name(wanted[place])}`);
    });
    return [...new Set(faults)];
  };
  return wanted.length;
}
