/** The sender of the frames of a shirt over the network; only a tap makes another sender the shirt. */
import { passFocus } from "../../focus.js";
import { h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { useUntilGone } from "../../widgets/made.js";

const LOOK_EVERY = 2000; // ms

/** Names the sender, and offers another sender when there is one. @param {{store: import("./store.js").ShirtStore}} sender */
export function ShirtSender({ store: { app, left } }) {
  const senders = useSignal(/** @type {import("types/api").SendersView | null} */ (null));
  const read = async () => {
    senders.value = await app.api.get("/equipment/sender").catch(() => senders.value);
  };
  /** @param {string} sender */
  const use = async (sender) => {
    await app.toasts.attempt(async () => {
      await app.api.put("/equipment/sender", { sender });
      app.toasts.show(t("sender-used", { sender }));
    });
    await read();
  };
  useUntilGone(left, (gone) => {
    const timer = setInterval(read, LOOK_EVERY);
    gone.addEventListener("abort", () => clearInterval(timer));
    read();
  });
  const { shirt = null, other = null, others = 0 } = senders.value ?? {};
  return h(
    "div",
    { class: "stack", "aria-live": "polite" },
    shirt && h("p", { class: "quiet small" }, t("sender-now", { shirt })),
    other && h("p", { class: "problem", id: "other-sender" }, t("sender-other", { shirt, other, others })),
    other &&
      h(
        "button",
        {
          type: "button",
          class: "btn",
          "aria-describedby": "other-sender",
          ref: passFocus,
          onClick: () => use(other),
        },
        t("sender-use"),
      ),
  );
}
