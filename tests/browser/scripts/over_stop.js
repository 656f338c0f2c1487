// What lies over Stop, at its corners and in its middle, and what of the header stands over its neighbour.
() => {
  const stop = document.getElementById("stop");
  if (!stop) return [];
  const { left, top, width, height } = stop.firstElementChild.getBoundingClientRect();
  const shares = [0.1, 0.5, 0.9];
  const points = shares.flatMap((x) => shares.map((y) => [left + x * width, top + y * height]));
  const over = points.map(([x, y]) => document.elementFromPoint(x, y)).filter((one) => !stop.contains(one));
  const wide = [...stop.closest(".head").children].filter(
    (one) => one.scrollWidth > one.clientWidth + 1 && getComputedStyle(one).overflowX === "visible",
  );
  return [
    ...[...new Set(over)].map((one) => `over Stop: ${one ? one.outerHTML.slice(0, 80) : "beside the window"}`),
    ...wide.map((one) => `over its neighbour: ${one.textContent}`),
  ];
}
