/**
 * The phones that are paired as sensors: pair one by a code, see which are connected, unpair one.
 * @import { OfferView, PhonesView, PhoneView } from "types/api"
 * @import { ShirtStore } from "./store.js"
 */
import { passFocus } from "../../focus.js";
import { onNews } from "../../live/news.js";
import { h, useOpening, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { useUntilGone } from "../../widgets/made.js";
import { pictureOf } from "../../widgets/one_time_key.js";

/** @type {import("../../live/news.js").Interest} */
const INTEREST = { what: ["phones", "equipment"] };

/** @param {{store: ShirtStore}} card */
export function PairedPhones({ store: { app, left } }) {
  const shown = useSignal(/** @type {PhonesView | null} */ (null));
  const offer = useSignal(/** @type {OfferView | null} */ (null));
  const place = useOpening(offer.value, ".paired > :first-child");
  /** @param {PhonesView} now */
  const show = (now) => {
    const before = shown.peek()?.phones;
    if (offer.peek() && before && now.phones.some(({ number }) => !before.some((phone) => phone.number === number))) {
      app.toasts.show(t("phones-paired"));
      offer.value = null;
    }
    shown.value = now;
  };
  const read = () => app.toasts.attempt(async () => show(await app.api.get("/phones")));
  const openCode = () =>
    app.toasts.attempt(async () => {
      offer.value = await app.api.post("/phones/pairing");
    });
  /** @param {number} number */
  const unpair = (number) =>
    app.toasts.attempt(async () => {
      show(await app.api.remove(`/phones/${number}`));
      app.toasts.show(t("phones-unpaired", { number }));
    });
  useUntilGone(left, (gone) => {
    onNews(app, gone, INTEREST, read);
    read();
  });
  const phones = shown.value?.phones ?? [];
  return h(
    "div",
    { class: "stack" },
    h("h3", {}, t("phones-title")),
    shown.value && !phones.length && h("p", { class: "quiet" }, t("phones-none")),
    h(
      "div",
      { class: "paired-chairs", role: phones.length ? "list" : undefined },
      phones.map((phone) => h(Row, { key: phone.number, phone, onUnpair: () => unpair(phone.number) })),
    ),
    h(
      "div",
      { ref: place },
      offer.value
        ? h(CodeView, { key: offer.value.code, offer: offer.value, openCode, onClose: () => void (offer.value = null) })
        : h("button", { type: "button", class: "btn", onClick: openCode }, t("phones-pair")),
    ),
  );
}

/** @param {{phone: PhoneView, onUnpair: () => void}} row */
function Row({ phone: { number, connected, part }, onUnpair }) {
  return h(
    "div",
    { class: "paired-chair row", role: "listitem" },
    h("b", {}, t("phones-name", { number })),
    h("span", { class: `tag ${connected ? "" : "att"}` }, t(`phones-${connected ? "connected" : "away"}`)),
    h("span", { class: "quiet small grow" }, part ? t("phones-part", { part }) : t("phones-no-part")),
    h(
      "button",
      {
        type: "button",
        class: "btn",
        "aria-label": t("phones-unpair-label", { number }),
        ref: passFocus,
        onClick: onUnpair,
      },
      t("phones-unpair"),
    ),
  );
}

/** The code to scan, and its link. @param {{offer: OfferView, openCode: () => void, onClose: () => void}} view */
function CodeView({ offer: { code, url, qr, message }, openCode, onClose }) {
  /** @param {string} text @param {() => void} onClick */
  const button = (text, onClick) => h("button", { type: "button", class: "btn", onClick }, text);
  return h(
    "div",
    { class: "paired" },
    h("h4", { tabindex: -1 }, t("phones-pair")),
    h("p", { role: "status" }, t("phones-scan")),
    message && h("p", { class: "att" }, message),
    h("img", { class: "qr", src: pictureOf(qr), alt: t("phones-qr"), width: 240, height: 240 }),
    h("p", {}, t("phones-type", { address: url.slice(0, url.indexOf("#")) })),
    h("p", { class: "typed-code" }, `${code.slice(0, 4)} ${code.slice(4)}`),
    h("pre", {}, h("code", {}, url)),
    h("div", { class: "spread" }, button(t("phones-again"), openCode), button(t("phones-close"), onClose)),
  );
}
