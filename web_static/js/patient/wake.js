/** Keeps the screen from going dark, where the browser can (on encrypted pages, and on the server's own computer). */

/** Request it now, and again whenever the page comes back into view: a hidden page loses it. */
export function stayAwake() {
  const ask = () => {
    if (document.visibilityState === "visible") navigator.wakeLock?.request("screen").catch(() => null);
  };
  document.addEventListener("visibilitychange", ask);
  ask();
}
