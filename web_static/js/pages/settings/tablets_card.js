/** The link with which a further tablet begins, as a code to scan; it follows the machine's address. */
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { pictureOf } from "../../widgets/one_time_key.js";

const LOOK_EVERY = 10_000; // ms

/** @param {import("../../main.js").App} app @param {AbortSignal} signal */
export function tabletsCard(app, signal) {
  const link = h("div", { role: "status" });
  let shown = "";
  const look = async () => {
    /** @type {import("types/api").TabletsView} */
    let tablets;
    try {
      tablets = await app.api.get("/tablets");
    } catch (error) {
      tablets = { url: null, qr: "", pages: "", message: failureWords(error) };
    }
    const { url, qr, message } = tablets;
    if (signal.aborted || shown === `${url} ${message}`) return;
    shown = `${url} ${message}`;
    put(
      link,
      url === null
        ? h("p", { class: "quiet" }, message)
        : [
            h("p", {}, t("tablets-scan")),
            h("img", { class: "qr", src: pictureOf(qr), alt: t("tablets-qr", { url }), width: 200, height: 200 }),
            h("p", { class: "small" }, url),
          ],
    );
  };
  look();
  const timer = setInterval(look, LOOK_EVERY);
  signal.addEventListener("abort", () => clearInterval(timer));
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("tablets-title")),
    h("p", { class: "quiet small" }, t("tablets-lead")),
    link,
  );
}
