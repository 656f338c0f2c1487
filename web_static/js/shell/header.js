/**
 * The header: product, who is here, lamps of the equipment, colours, sign-out, Stop.
 * @import { App } from "../main.js"
 * @import { FrameState } from "./frame_state.js"
 * @import { Theme } from "./theme.js"
 * @import { IconName } from "../widgets/icons.js"
 * @typedef {{kind: string, words: string}} LampLook kind: further classes
 */
import { computed, effect, Fragment, h, render, useComputed, useRef, useSignal } from "../preact.js";
import { t } from "../texts.js";
import { Icon } from "../widgets/icons.js";
import { ScreenLamp } from "./screen_lamp.js";
import { practiceMark } from "./practice_mark.js";
import { stopButton } from "./stop.js";
import { SubjectPlace } from "./subject.js";
import { chosenTheme, nextTheme } from "./theme.js";

/** @type {Record<Theme, IconName>} */
const THEME_ICONS = { system: "sun", light: "sun", dark: "moon", contrast: "contrast" };

/** @param {App} app */
export function header(app) {
  const { me, practice, picture } = app.state;
  const element = document.createElement("header");
  const mark = practiceMark();
  render(h(Contents, { app }), element);
  element.querySelector(".tag")?.after(mark.element);
  element.append(stopButton(app));
  const hasChair = computed(() => Boolean(picture.value.latest?.chair?.state));
  effect(() => {
    element.className = hasChair.value ? "head has-chair" : "head";
  });
  effect(() => mark.show(me.value?.demo ? null : practice.value)); // a demonstration has a mark of its own
  // Long words make the header higher: what stands below it follows.
  const below = new ResizeObserver(() =>
    document.documentElement.style.setProperty("--head", `${element.offsetHeight}px`),
  );
  below.observe(element);
  return element;
}

/** All but the mark of practice and Stop, which are made by hand. @param {{app: App}} header */
function Contents({ app }) {
  const { state } = app;
  const me = state.me.value;
  const isSignedIn = Boolean(me?.signed_in);
  const isPerson = isSignedIn && !me?.demo;
  return h(
    Fragment,
    {},
    h("span", { class: "brand" }, t("app-name")),
    h("span", { class: "tag calm", title: t("demo-explained"), hidden: !me?.demo }, t("demo-tag")),
    h(SubjectPlace, { state }),
    h(
      "div",
      { class: "lamps", style: { visibility: isSignedIn ? "" : "hidden" } },
      h(Lamp, { state, look: shirtLamp }),
      h(Lamp, { state, look: chairLamp }),
      h(ScreenLamp, { app }),
      h("span", { class: "me", hidden: !isPerson }, isPerson && me?.name),
    ),
    h(
      "div",
      { class: "tools" },
      h(HelpButton, { app, isShown: isSignedIn }),
      h(ThemeButton, { app }),
      h(
        "button",
        {
          type: "button",
          class: "icon-button",
          title: t("sign-out"),
          "aria-label": t("sign-out"),
          hidden: !isPerson,
          disabled: !state.isConnected.value, // signing out needs the server
          onClick: () => app.signOut(),
        },
        h(Icon, { name: "leave", size: 22 }),
      ),
    ),
  );
}

/**
 * A lamp with its words; of twenty pictures a second, it changes only with those that look otherwise.
 * @param {{state: FrameState, look: (picture: FrameState["picture"]["value"]) => LampLook}} lamp
 */
function Lamp({ state, look }) {
  const now = useComputed(() => look(state.picture.value));
  const kind = useComputed(() => `lamp ${now.value.kind}`);
  const words = useComputed(() => now.value.words);
  return h("span", { class: kind }, words);
}

/** @type {(picture: FrameState["picture"]["value"]) => LampLook} */
function shirtLamp({ present, quality }) {
  if (!present) return { kind: "off unknown", words: t("lamp-shirt-unknown") };
  const { alive, chosen } = present.shirt;
  if (chosen === false) return { kind: "off", words: t("lamp-shirt-none") };
  const all = quality.length;
  const good = quality.filter((one) => one === "good").length;
  const estimated = quality.filter((one) => one === "estimated").length;
  const kind = estimated ? "att long" : alive && good >= all * 0.75 ? "" : "att";
  const key = estimated ? "lamp-shirt-estimated" : "lamp-shirt";
  return { kind, words: alive && all ? t(key, { good, all, estimated }) : t("lamp-shirt-silent") };
}

/** @type {(picture: FrameState["picture"]["value"]) => LampLook} */
function chairLamp({ present }) {
  if (!present) return { kind: "off unknown wide", words: t("lamp-chair-unknown") };
  const isArmed = present.state === "armed";
  const state = present.chair?.state;
  const isBad = state === "silent" || state === "fault";
  const words = state ? t("lamp-real", { state: t(`lamp-real-${state}`) }) : t(isArmed ? "lamp-armed" : "lamp-chair");
  return { kind: `${isBad ? "att" : isArmed ? "" : "off"} ${state ? "long" : "wide"}`, words };
}

/** @param {{app: App, isShown: boolean}} button */
function HelpButton({ app, isShown }) {
  const button = useRef(/** @type {HTMLButtonElement | null} */ (null));
  const open = async () => {
    const { openPageHelp } = await import("../help/page_help.js");
    if (button.current) await openPageHelp(app, button.current);
  };
  return h(
    "button",
    {
      type: "button",
      class: "icon-button",
      title: t("help-open"),
      "aria-label": t("help-open"),
      "aria-expanded": "false", // openPageHelp changes it
      hidden: !isShown,
      disabled: !app.state.isConnected.value, // the help is loaded from the server
      ref: button,
      onClick: open,
    },
    h(Icon, { name: "question", size: 22 }),
  );
}

/** @param {{app: App}} button */
function ThemeButton({ app }) {
  const choice = useSignal(chosenTheme());
  const label = t("theme-label", { theme: t(`theme-${choice.value}`) });
  const change = () => {
    choice.value = nextTheme();
    app.toasts.show(t("theme-now", { theme: t(`theme-${choice.value}`) }));
  };
  return h(
    "button",
    { type: "button", class: "icon-button", "aria-label": label, title: label, onClick: change },
    h(Icon, { name: THEME_ICONS[choice.value], size: 22 }),
  );
}
