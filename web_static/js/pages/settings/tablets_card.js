/**
 * The link with which a further tablet begins, as a code to scan; it follows the machine's address.
 * @import { TabletsView } from "types/api"
 */
import { failureWords } from "../../api.js";
import { Fragment, h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { useUntilGone } from "../../widgets/made.js";
import { pictureOf } from "../../widgets/one_time_key.js";

const READ_EVERY = 10_000; // ms

/** @param {{app: import("../../main.js").App, left: AbortSignal}} card */
export function TabletsCard({ app, left }) {
  const tablets = useSignal(/** @type {Pick<TabletsView, "url" | "qr" | "message"> | null} */ (null));
  const read = async () => {
    tablets.value = await app.api
      .get("/tablets")
      .catch((error) => ({ url: null, qr: "", message: failureWords(error) }));
  };
  useUntilGone(left, (gone) => {
    const timer = setInterval(read, READ_EVERY);
    gone.addEventListener("abort", () => clearInterval(timer));
    read();
  });
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("tablets-title")),
    h("p", { class: "quiet small" }, t("tablets-lead")),
    h("div", { role: "status" }, tablets.value && link(tablets.value)),
  );
}

/** @param {Pick<TabletsView, "url" | "qr" | "message">} tablets */
function link({ url, qr, message }) {
  if (url === null) return h("p", { class: "quiet" }, message);
  return h(
    Fragment,
    {},
    h("p", {}, t("tablets-scan")),
    h("img", { class: "qr", src: pictureOf(qr), alt: t("tablets-qr", { url }), width: 200, height: 200 }),
    h("p", { class: "small" }, url),
  );
}
