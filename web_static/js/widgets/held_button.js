/** Buttons that act again and again while they are held. */

const HOLD_BEFORE = 400; // ms that a button is held before it repeats
const REPEAT_EVERY = 90; // ms

/** @param {HTMLButtonElement} button @param {() => void} act */
export function repeatWhileHeld(button, act) {
  let timer = 0;
  const end = () => clearTimeout(timer);
  const again = () => {
    if (button.disabled || !button.isConnected) return end();
    act();
    timer = setTimeout(again, REPEAT_EVERY);
  };
  button.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    act();
    end();
    timer = setTimeout(again, HOLD_BEFORE);
  });
  for (const event of ["pointerup", "pointerleave", "pointercancel"]) button.addEventListener(event, end);
  button.addEventListener("click", (event) => event.detail === 0 && act());
}
