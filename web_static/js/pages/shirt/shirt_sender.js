/** The sender of the frames of a shirt over the network; only a tap makes another sender the shirt. */
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";

const LOOK_EVERY = 2000; // ms

/**
 * An element that names the sender, and offers another sender when there is one. It is refreshed until `signal` aborts.
 * @param {import("../../main.js").App} app @param {AbortSignal} signal
 */
export function shirtSender(app, signal) {
  const element = h("div", { class: "stack", "aria-live": "polite" });
  let shown = "";
  /** @param {import("types/api").SendersView} senders */
  const show = (senders) => {
    const key = JSON.stringify([senders.shirt, senders.other]);
    if (key === shown) return; // a button that is drawn anew would lose the focus
    shown = key;
    put(
      element,
      senders.shirt && h("p", { class: "quiet small" }, t("sender-now", { shirt: senders.shirt })),
      senders.other &&
        h(
          "p",
          { class: "problem", id: "other-sender" },
          t("sender-other", { shirt: senders.shirt, other: senders.other, others: senders.others }),
        ),
      senders.other &&
        h(
          "button",
          { type: "button", class: "btn", "aria-describedby": "other-sender", onclick: () => use(senders.other) },
          t("sender-use"),
        ),
    );
  };
  const look = async () => {
    const senders = await app.api.get("/equipment/sender").catch(() => null);
    if (senders && !signal.aborted) show(senders);
  };
  /** @param {string} sender */
  const use = async (sender) => {
    await app.toasts.attempt(async () => {
      await app.api.put("/equipment/sender", { sender });
      app.toasts.show(t("sender-used", { sender }));
    });
    await look();
  };
  const timer = setInterval(look, LOOK_EVERY);
  signal.addEventListener("abort", () => clearInterval(timer));
  look();
  return element;
}
