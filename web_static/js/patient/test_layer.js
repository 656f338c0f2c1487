/** The two-minute test on the patient's screen: the cross, as large as the screen allows, and nothing else. */
import { h, useComputed, useLayoutEffect, useMemo, useRef } from "../preact.js";
import { targetCross } from "../interface_test/target_cross.js";
import { t } from "../texts.js";

/** @param {import("./screen.js").Newest} layer */
export function TestLayer({ now }) {
  const layer = useRef(/** @type {HTMLDivElement | null} */ (null));
  const cross = useMemo(targetCross, []);
  const phase = useComputed(() => (now.value?.state === "fault" ? null : now.value?.test?.phase)).value;
  useLayoutEffect(() => {
    layer.current?.append(cross.element);
    return now.subscribe((message) => message?.test && cross.show(message.test));
  }, []);
  return h(
    "div",
    { class: "test-layer", hidden: !phase, ref: layer },
    h("p", { class: "test-words", role: "status" }, phase && t(`patient-test-${phase}`)),
  );
}
