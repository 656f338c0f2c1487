/**
 * A link that is shown once, as a QR code and as text to copy, with how long it holds.
 * @import { LinkView } from "types/api"
 */
import { h } from "../../preact.js";
import { t } from "../../texts.js";
import { copyText } from "../../widgets/clipboard.js";
import { moment } from "../../widgets/format.js";
import { pictureOf } from "../../widgets/one_time_key.js";

/** @param {{app: import("../../main.js").App, link: LinkView, onDone: () => void}} card */
export function LinkCard({ app, link: { person, url, qr, expires, message }, onDone }) {
  const { name } = person;
  const key = person.state === "invited" ? "people-link-new" : "people-link-password";
  const copy = () => copyText(app, url, t("screens-copied"), t("screens-copy-failed"));
  return h(
    "section",
    { class: "card paired" },
    h("h2", { tabindex: -1 }, t(key, { name })),
    h("p", {}, t("people-link-lead", { name, until: moment(expires) })),
    message && h("p", { class: "att" }, message),
    h("img", { class: "qr", src: pictureOf(qr), alt: t("people-link-qr", { name }), width: 240, height: 240 }),
    h("pre", {}, h("code", {}, url)),
    h(
      "div",
      { class: "spread" },
      h("button", { type: "button", class: "btn", onClick: copy }, t("screens-copy")),
      h("button", { type: "button", class: "btn go", onClick: onDone }, t("people-link-done")),
    ),
  );
}
