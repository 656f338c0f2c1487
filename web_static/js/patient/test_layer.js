/** The two-minute test on the patient's screen: the cross, as large as the screen allows, and nothing else. */
import { h, write } from "../widgets/dom.js";
import { targetCross } from "../interface_test/target_cross.js";
import { t } from "../texts.js";

export function testLayer() {
  const cross = targetCross();
  const words = h("p", { class: "test-words", role: "status" });
  const element = h("div", { class: "test-layer", hidden: true }, words, cross.element);
  /** @param {import("../live/live.js").PatientMessage} now */
  const show = ({ test, state }) => {
    element.hidden = !test || state === "fault";
    if (!test) return;
    cross.show(test);
    write(words, t(`patient-test-${test.phase}`));
  };
  return { element, show };
}
