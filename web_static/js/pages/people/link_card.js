/**
 * A link that is shown once, as a QR code and as text to copy, with how long it holds.
 * @import { LinkView } from "types/api"
 */
import { t } from "../../texts.js";
import { copyText } from "../../widgets/clipboard.js";
import { h } from "../../widgets/dom.js";
import { moment } from "../../widgets/format.js";
import { pictureOf } from "../../widgets/one_time_key.js";

/** @param {import("../../main.js").App} app @param {LinkView} link @param {() => void} onDone */
export function linkCard(app, { person, url, qr, expires, message }, onDone) {
  const copy = () => copyText(app, url, t("screens-copied"), t("screens-copy-failed"));
  const key = person.state === "invited" ? "people-link-new" : "people-link-password";
  return h(
    "section",
    { class: "card paired" },
    h("h2", { tabindex: "-1" }, t(key, { name: person.name })),
    h("p", {}, t("people-link-lead", { name: person.name, until: moment(expires) })),
    message && h("p", { class: "att" }, message),
    h("img", {
      class: "qr",
      src: pictureOf(qr),
      alt: t("people-link-qr", { name: person.name }),
      width: 240,
      height: 240,
    }),
    h("pre", {}, h("code", {}, url)),
    h(
      "div",
      { class: "spread" },
      h("button", { type: "button", class: "btn", onclick: copy }, t("screens-copy")),
      h("button", { type: "button", class: "btn go", onclick: onDone }, t("people-link-done")),
    ),
  );
}
