/**
 * The lamp of the patient's screens in the header: there is one while a screen is paired.
 * @import { ScreensView } from "types/api"
 */
import { concerns } from "../live/news.js";
import { screenState } from "../pages/drive/screen_words.js";
import { effect, h, useComputed, useLayoutEffect, useSignal } from "../preact.js";
import { t } from "../texts.js";

const SETTLES = 300; // ms: the end of a session unpairs its screens before the live picture says that it has ended

/** @param {{app: import("../main.js").App}} lamp */
export function ScreenLamp({ app }) {
  const { me, isLocked, picture } = app.state;
  const session = useComputed(() => picture.value.present?.session ?? null); // its id; without one nothing is paired
  const screens = useSignal(/** @type {ScreensView["screens"]} */ ([]));
  useLayoutEffect(() => {
    const refresh = async () => {
      const { value: who } = me;
      const mayAsk = session.value !== null && who?.signed_in && who.role !== "reviewer" && !isLocked.value;
      screens.value = mayAsk ? ((await app.api.get("/patient-screen").catch(() => null))?.screens ?? []) : [];
    };
    effect(() => void refresh());
    app.live.addEventListener("changed", ({ detail }) => {
      if (concerns(detail, { what: ["screens"] })) setTimeout(refresh, SETTLES);
    });
  }, []);
  const state = screenState(screens.value);
  const isHidden = state === "-none";
  const isBad = state !== "" && !isHidden;
  const kind = isBad ? "att long" : "wide"; // on a small screen only what is not right
  return h(
    "span",
    { class: `lamp screen-lamp ${kind}`, hidden: isHidden },
    isHidden ? "" : t(`lamp-screen${state}`, { count: screens.value.length }),
  );
}
