/** Counts the pictures that a frame draws, or the whole page, over two seconds. */

const WINDOW = 2000; // ms

/** @returns {{perSecond: (frame: HTMLIFrameElement) => number}} Infinity within the first two seconds */
export function frameCounter() {
  /** The window whose pictures are counted. @type {Window | null} */
  let counted = null;
  let pictures = 0;
  let since = 0;
  return {
    perSecond(frame) {
      const view = frame.contentWindow;
      if (view && counted !== view) {
        counted = view;
        const count = () => {
          pictures += 1;
          if (counted === view) view.requestAnimationFrame(count);
        };
        [pictures, since] = [0, performance.now()];
        count();
      }
      const time = performance.now() - since;
      if (time < WINDOW || document.visibilityState !== "visible") return Infinity;
      const rate = (1000 * pictures) / time;
      [pictures, since] = [0, performance.now()];
      return rate;
    },
  };
}

/**
 * Count the pictures that this page draws, its 3D view among them: a browser draws a page and its frames together.
 * @returns {Promise<number | null>} a second; null: the page is out of view and draws none
 */
export function pagePictures() {
  let pictures = 0;
  let isCounting = true;
  const since = performance.now();
  const count = () => {
    pictures += 1;
    if (isCounting) requestAnimationFrame(count);
  };
  requestAnimationFrame(count);
  return new Promise((resolve) =>
    setTimeout(() => {
      isCounting = false;
      const rate = (1000 * pictures) / (performance.now() - since);
      resolve(document.visibilityState === "visible" ? Number(rate.toFixed(1)) : null);
    }, WINDOW),
  );
}
