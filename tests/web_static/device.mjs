// Which device a browser runs on, and its name on the page that connects it. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const from = (file) => import(pathToFileURL(`${process.argv[2]}/${file}`));
const { deviceOf } = await from("tablet/steps.js");
const { t } = await from("tablet/texts.js");

const MAC = "Mozilla/5.0 (Macintosh; Intel Mac OS X 10_15_7) Version/18.0 Safari/605.1.15";
for (const [userAgent, platform, maxTouchPoints, name] of [
  [MAC, "MacIntel", 5, "iPad or iPhone"],
  [MAC, "MacIntel", 0, "Mac"],
  ["Mozilla/5.0 (iPhone; CPU iPhone OS 18_0 like Mac OS X)", "iPhone", 5, "iPad or iPhone"],
  ["Mozilla/5.0 (Linux; Android 15; Tablet) Chrome/140.0", "Linux armv8l", 5, "Android"],
  ["Mozilla/5.0 (Windows NT 10.0; Win64; x64) Chrome/140.0", "Win32", 10, "Windows"],
  ["Mozilla/5.0 (X11; Linux x86_64; rv:140.0) Firefox/140.0", "Linux x86_64", 0, "Linux"],
])
  assert.equal(t(`tablet-${deviceOf({ userAgent, platform, maxTouchPoints })}`), name);
console.log("devices hold");
