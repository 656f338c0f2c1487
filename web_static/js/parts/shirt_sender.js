/** Who sends the frames of a shirt over the network; another sender becomes the shirt by a tap, and only so. */
import { t } from "../texts.js";
import { h, put } from "./dom.js";

const LOOK_EVERY = 2000; // ms

/**
 * A place that says who sends, and asks when somebody else does too. It looks again until `signal` ends it.
 * @param {import("../main.js").App} app @param {AbortSignal} signal
 */
export function shirtSender(app, signal) {
  const element = h("div", { class: "stack", "aria-live": "polite" });
  let shown = "";
  const show = (senders) => {
    const key = JSON.stringify([senders.shirt, senders.other]);
    if (key === shown) return; // a button that is drawn anew would lose the focus
    shown = key;
    put(
      element,
      senders.shirt && h("p", { class: "quiet small" }, t("sender.now", { shirt: senders.shirt })),
      senders.other && h("p", { class: "problem", id: "other-sender" }, t("sender.other", senders)),
      senders.other &&
        h(
          "button",
          { type: "button", class: "btn", "aria-describedby": "other-sender", onclick: () => use(senders.other) },
          t("sender.use"),
        ),
    );
  };
  const look = async () => {
    const senders = await app.api.get("/equipment/sender").catch(() => null);
    if (senders && !signal.aborted) show(senders);
  };
  const use = async (sender) => {
    try {
      await app.api.put("/equipment/sender", { sender });
      app.toasts.show(t("sender.used", { sender }));
    } catch (error) {
      app.toasts.show(error.message);
    }
    await look();
  };
  const timer = setInterval(look, LOOK_EVERY);
  signal.addEventListener("abort", () => clearInterval(timer));
  look();
  return element;
}
