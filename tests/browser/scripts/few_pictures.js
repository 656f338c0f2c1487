// Lets a page draw three pictures a second at most, and its 3D view in a quarter of its pixels.
(() => {
  if (window !== top) Object.defineProperty(window, "devicePixelRatio", { get: () => 0.5 });
  const pause = 320;  // ms
  const next = window.requestAnimationFrame.bind(window), cancel = window.cancelAnimationFrame.bind(window);
  window.everyPicture = next;  // for a test that waits until the browser has drawn
  const pending = new Map();
  let last = 0, count = 0;
  window.requestAnimationFrame = (draw) => {
    const id = ++count;
    const later = (now) => {
      if (now !== last && now - last <= pause) return void pending.set(id, next(later));
      last = now;
      pending.delete(id);
      draw(now);
    };
    pending.set(id, next(later));
    return id;
  };
  window.cancelAnimationFrame = (id) => {
    cancel(pending.get(id));
    pending.delete(id);
  };
})()
