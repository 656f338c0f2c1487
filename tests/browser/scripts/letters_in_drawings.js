// Where the letters of these texts are, and what colour they have; the first one is scrolled into the middle.
(targets) => {
  const found = targets.map((target) => document.querySelector(target));
  found.find(Boolean)?.scrollIntoView({ block: "center", inline: "center", behavior: "instant" });
  return found.map((one, number) => {
    if (!one?.checkVisibility()) return null;
    const box = one.getBoundingClientRect();
    if (!box.width) return null; // a text without letters
    const style = getComputedStyle(one);
    const scale = one.getScreenCTM?.()?.a ?? 1;
    let opacity = Number(style.fillOpacity);
    for (let each = one; each; each = each.parentElement) opacity *= Number(getComputedStyle(each).opacity);
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const over = document.elementFromPoint(x, y);
    const drawing = one.ownerSVGElement;
    return {
      number, opacity, colour: style.fill, weight: Number(style.fontWeight), size: parseFloat(style.fontSize) * scale,
      box: [box.left, box.top, box.right, box.bottom],
      isSeen: box.left >= 0 && box.top >= 0 && box.right <= innerWidth && box.bottom <= innerHeight
        && (!over || drawing.contains(over) || over.contains(drawing) || drawing.parentElement.contains(over)),
    };
  });
}
