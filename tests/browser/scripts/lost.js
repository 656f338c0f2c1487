// What cannot be seen or reached: what scrolls sideways, lies beside the window or under something, or is cut off.
() => {
  const lost = [];
  const name = (one) => `${one.tagName.toLowerCase()}.${String(one.getAttribute("class") ?? "").replaceAll(" ", ".")}`
    + ` "${(one.getAttribute("aria-label") ?? one.textContent).trim().slice(0, 40)}"`;
  const inside = ({ left, top, right, bottom }) =>
    left >= -1 && top >= -1 && right <= innerWidth + 1 && bottom <= innerHeight + 1 && right > left && bottom > top;
  if (document.documentElement.scrollWidth > innerWidth) lost.push("the window scrolls sideways");
  for (const one of document.querySelectorAll("main, .app, .card"))
    if (one.checkVisibility() && one.scrollWidth > one.clientWidth + 1 && getComputedStyle(one).overflowX !== "visible")
      lost.push(`scrolls sideways: ${name(one)}`);
  for (const one of document.querySelectorAll("main :is(button, a.btn, input:not(.unseen), select, h1, h2, p)")) {
    if (!one.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
    if (one.closest(".scroll-x, .unseen, [inert], [type=file], label.choice, .segments, label.switch")) continue;
    one.scrollIntoView({ block: "center", inline: "nearest", behavior: "instant" });
    const box = one.getBoundingClientRect();
    if (!box.width) continue;
    if (box.left < -1 || box.right > innerWidth + 1) lost.push(`beside the window: ${name(one)}`);
    if (!one.matches("button, a, input, select")) continue;
    const at = document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
    const card = at?.closest(".fault-card, .page-help, .question, .toast");
    if (card && !card.contains(one)) continue; // the card is answered or closed first, and then this is in view again
    const isHit = at && (one.contains(at) || at.contains(one) || at.closest("label")?.contains(one));
    if (!isHit && !one.disabled) lost.push(`covered: ${name(one)}${at ? ` by ${name(at)}` : ""}`);
    if (!one.matches(".btn.go")) continue;
    const isCut = one.scrollWidth > one.clientWidth + 1 || one.scrollHeight > one.clientHeight + 1;
    if (isCut || !inside(box)) lost.push(`the main button is cut off: ${name(one)}`);
  }
  const stop = document.getElementById("stop");
  if (stop && !inside(stop.firstElementChild.getBoundingClientRect())) lost.push("Stop is out of view");
  const head = document.querySelector(".head");
  const top = head?.getBoundingClientRect().bottom ?? 0;
  for (const toast of document.querySelectorAll(".toast"))
    if (toast.getBoundingClientRect().top < top) lost.push("a message under the header");
  const corner = stop?.getBoundingClientRect();
  const isMirrored = getComputedStyle(document.documentElement).direction === "rtl";
  const beside = corner && (isMirrored ? corner.left : innerWidth - corner.right);
  if (corner && (corner.top > 1 || beside > 1)) lost.push("Stop is not in its corner");
  if (head && head.scrollHeight > head.clientHeight + 1) lost.push("the header stands over the page");
  return lost;
}
