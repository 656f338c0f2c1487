/** The key of a chair that was just paired: shown this once, with what to do on the chair. */
import { h } from "../preact.js";
import { t } from "../texts.js";
import { copyText } from "./clipboard.js";

/**
 * @param {object} card
 * @param {import("../main.js").App} card.app @param {{key_line: string, qr: string}} card.answer of POST /chairs
 * @param {{name: string, host: string, port: number}} card.chair @param {() => void} card.onDone
 */
export function PairedCard({ app, answer: { key_line: line, qr }, chair: { name, host, port }, onDone }) {
  const start = `bodydrive chair receive --key-file chair.key --output ros2 --bind ${host} --port ${port}`;
  const copy = () => copyText(app, line, t("paired-copied"), t("paired-copy-failed"));
  /** @param {string} words */
  const code = (words) => h("pre", {}, h("code", {}, words));
  return h(
    "section",
    { class: "paired" },
    h("h2", { tabindex: -1 }, t("paired-title", { name })),
    h("p", {}, t("paired-lead")),
    h("img", { class: "qr", src: pictureOf(qr), alt: t("paired-qr", { name }), width: 240, height: 240 }),
    h(
      "ol",
      {},
      h("li", {}, t("paired-step-scan"), code("umask 077\ncat > chair.key")),
      h(
        "li",
        {},
        t("paired-step-start"),
        code(start),
        h("a", { href: "/docs/chairs", target: "_blank" }, t("paired-outputs")),
      ),
      h("li", {}, t("paired-step-look")),
    ),
    h(
      "details",
      {},
      h("summary", {}, t("paired-line")),
      code(line),
      h("button", { type: "button", class: "btn small", onClick: copy }, t("paired-copy")),
    ),
    h("button", { type: "button", class: "btn go", onClick: onDone }, t("paired-done")),
  );
}

/** An SVG as the address of a picture: nothing in it can run. @param {string} svg */
export function pictureOf(svg) {
  return `data:image/svg+xml;utf8,${encodeURIComponent(svg)}`;
}
