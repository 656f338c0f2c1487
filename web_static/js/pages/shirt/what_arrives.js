/** What arrives from the source in use, without being asked; and once signals do, which joint moves. */
import { status } from "../../camera/camera.js";
import { h } from "../../preact.js";
import { t } from "../../texts.js";
import { jointWithin } from "../../widgets/joint_words.js";
import { arrivalWords } from "./arrival_words.js";
import { Spoken } from "./spoken.js";

/** @param {{store: import("./store.js").ShirtStore}} arrivals */
export function WhatArrives({ store }) {
  const { live, equipment } = store;
  const { shirt, body, simulated } = equipment.value;
  const said = arrivalWords(live.value.arrivals, shirt?.kind === "camera" ? status.value : "");
  if (said?.state === "waiting") return h("p", { class: "quiet small" }, h(Spoken, { words: said.words }));
  if (said)
    return h(
      "div",
      { class: "problem arrivals" },
      h("h3", {}, t(said.state === "silent" ? "source-nothing" : "source-heed")),
      h(Spoken, { words: said.words }),
    );
  const mayMove = !simulated || body?.kind === "visitor";
  return mayMove && live.value.isSending && h(Wiggle, { store });
}

/** @param {{store: import("./store.js").ShirtStore}} wiggle */
function Wiggle({ store: { equipment, most } }) {
  const { channels = [], joints = [] } = equipment.value.layout ?? {};
  const name = channels[most.value]?.joint;
  const joint = joints.find((one) => one.name === name);
  return h(
    "p",
    { class: "small" },
    t("shirt-wiggle"),
    " ",
    joint && h("b", {}, t("shirt-moves", { joint: jointWithin(joint) })),
  );
}
