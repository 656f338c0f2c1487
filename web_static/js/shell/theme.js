/** Light, dark or high contrast: what a person chose on this screen, otherwise what the system prefers. */

const PLACE = "bodydrive-theme";
const CHOICES = /** @type {const} */ (["system", "light", "dark", "contrast"]);
const DARK = matchMedia("(prefers-color-scheme: dark)");
const CONTRAST = matchMedia("(prefers-contrast: more)");

/** @typedef {typeof CHOICES[number]} Theme */

/** @returns {Theme} */
export function chosenTheme() {
  try {
    const stored = localStorage.getItem(PLACE);
    return CHOICES.find((choice) => choice === stored) ?? "system";
  } catch {
    return "system"; // a browser that keeps nothing
  }
}

/** Take the next choice, and return it. */
export function nextTheme() {
  const next = CHOICES[(CHOICES.indexOf(chosenTheme()) + 1) % CHOICES.length];
  localStorage.setItem(PLACE, next);
  applyTheme();
  return next;
}

/** Set the theme's attribute for the style sheets, and tell the canvases by the event `themechange`. */
function applyTheme() {
  const choice = chosenTheme();
  const system = CONTRAST.matches ? "contrast" : DARK.matches ? "dark" : "light";
  document.documentElement.dataset.theme = choice === "system" ? system : choice;
  document.dispatchEvent(new Event("themechange"));
}

/** Follow the system from now on. */
export function followSystem() {
  applyTheme();
  DARK.addEventListener("change", applyTheme);
  CONTRAST.addEventListener("change", applyTheme);
}

/** The colour behind a meaning of tokens.css. @param {string} name without the dashes */
export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/**
 * Colours that follow the theme, looked up only when it changes: canvases ask for them in every picture.
 * @template {string} Name @param {...Name} names without the dashes
 */
export function palette(...names) {
  const colours = /** @type {Record<Name, string>} */ ({});
  const read = () => {
    for (const name of names) {
      // A custom property may name another one: the browser resolves it only on a real property.
      const probe = document.createElement("i");
      probe.style.color = `var(--${name})`;
      document.body.append(probe);
      colours[name] = getComputedStyle(probe).color;
      probe.remove();
    }
  };
  read();
  document.addEventListener("themechange", read);
  return { colours, stop: () => document.removeEventListener("themechange", read) };
}
