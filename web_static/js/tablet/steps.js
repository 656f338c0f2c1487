/** The steps by which a device learns to trust the clinic's machine, by the kind of device. */
import { h } from "../widgets/dom.js";
import { screenPicture } from "./pictures.js";
import { t } from "./texts.js";

/** @typedef {"apple" | "android" | "windows" | "mac" | "linux" | "own" | "nothing"} Device */
/** @typedef {import("./pictures.js").Row} Row */
/** @typedef {{picture?: [string, string[]], file?: string, code?: string}} Step  A picture's row that begins with ! is tapped, with !! a switch */

/** @type {readonly Device[]} */
export const DEVICES = ["apple", "android", "windows", "mac", "linux", "own", "nothing"];
const PROFILE = "bodydrive.mobileconfig";
const AUTHORITY = "bodydrive-authority.crt";

/** @type {Readonly<Record<Device, Step[]>>} */
const STEPS = {
  apple: [
    { file: PROFILE, picture: ["allow", ["Ignore", "!Allow"]] },
    { picture: ["Settings", ["!downloaded", "wifi", "General"]] },
    { picture: ["General", ["!About", "!trust"]] },
    { picture: ["trust", ["!!bodydrive"]] },
  ],
  android: [
    { file: AUTHORITY, picture: ["Downloads", ["!file"]] },
    { picture: ["install", ["!ca", "vpn", "wifi"]] },
    { picture: ["warning", ["dont", "!anyway", "!file"]] },
    { picture: ["Settings", ["!Chrome"]] },
  ],
  windows: [
    { file: AUTHORITY, picture: ["Certificate", ["bodydrive", "!install-certificate"]] },
    { picture: ["wizard", ["!user", "!store", "!Browse"]] },
    { picture: ["select", ["Personal", "!roots"]] },
  ],
  mac: [
    { file: AUTHORITY, picture: ["Downloads", ["!file"]] },
    { picture: ["keychain", ["login", "!bodydrive"]] },
    { picture: ["Trust", ["using", "!always"]] },
  ],
  linux: [
    { file: AUTHORITY, picture: ["Downloads", ["!file"]] },
    { picture: ["manage", ["!Import", "file"]] },
    { code: `certutil -d sql:$HOME/.pki/nssdb -A -t C,, -n bodydrive -i ${AUTHORITY}` },
  ],
  own: [{ code: "bodydrive serve --lan --certificate FILE --key FILE" }, {}],
  nothing: [{}, {}],
};

/**
 * What kind of device a browser runs on. An iPad says that it is a Mac, but no Mac has a touch screen.
 * @param {{userAgent: string, platform: string, maxTouchPoints: number}} browser @returns {Device}
 */
export function deviceOf({ userAgent, platform, maxTouchPoints }) {
  if (/iPad|iPhone|iPod/.test(userAgent) || (platform === "MacIntel" && maxTouchPoints > 1)) return "apple";
  if (/Android/.test(userAgent)) return "android";
  if (/Windows/.test(userAgent)) return "windows";
  return /Mac OS X/.test(userAgent) ? "mac" : "linux";
}

/** The list of steps for a device. @param {Device} device */
export function stepList(device) {
  return h(
    "ol",
    { class: "steps" },
    STEPS[device].map((step, index) => {
      const id = `tablet-${device}-${index + 1}`;
      return h(
        "li",
        {},
        h("p", {}, h("b", {}, `${index + 1}. `), t(id)),
        step.file && h("a", { class: "go", href: `/${step.file}`, download: step.file }, t(`${id}-file`)),
        step.code && h("code", {}, step.code),
        step.picture && picture(...step.picture),
      );
    }),
  );
}

/** @param {string} title @param {string[]} rows */
function picture(title, rows) {
  return screenPicture(
    t(`tablet-picture-${title}`),
    rows.map((row) => ({
      text: t(`tablet-picture-${row.replace(/^!+/, "")}`),
      mark: row.startsWith("!"),
      toggle: row.startsWith("!!"),
    })),
  );
}
