/** The header: product, who is here, lamps of the equipment, colours, sign-out, Stop. */
import { t } from "../texts.js";
import { h, set, write } from "../widgets/dom.js";
import { icon } from "../widgets/icons.js";
import { screenLamp } from "./screen_lamp.js";
import { practiceMark } from "./practice_mark.js";
import { stopButton } from "./stop.js";
import { subjectPlace } from "./subject.js";
import { chosenTheme, nextTheme } from "./theme.js";

/** @type {Record<import("./theme.js").Theme, import("../widgets/icons.js").IconName>} */
const THEME_ICONS = { system: "sun", light: "sun", dark: "moon", contrast: "contrast" };

/** @param {import("../main.js").App} app */
export function header(app) {
  const who = subjectPlace(app);
  const me = h("span", { class: "me" });
  const demo = h("span", { class: "tag calm", title: t("demo-explained") }, t("demo-tag"));
  const practice = practiceMark();
  const shirt = h("span", { class: "lamp" });
  const chair = h("span", { class: "lamp" });
  const screen = screenLamp(app);
  const lamps = h("div", { class: "lamps" }, shirt, chair, screen, me);
  const theme = themeButton(app);
  /** @type {HTMLButtonElement} */
  const help = h(
    "button",
    {
      type: "button",
      class: "icon-button",
      title: t("help-open"),
      "aria-label": t("help-open"),
      "aria-expanded": "false",
      onclick: async () => (await import("../help/page_help.js")).openPageHelp(app, help),
    },
    icon("question", 22),
  );
  const leave = h(
    "button",
    {
      type: "button",
      class: "icon-button",
      title: t("sign-out"),
      "aria-label": t("sign-out"),
      onclick: () => app.signOut(),
    },
    icon("leave", 22),
  );
  const element = h(
    "header",
    { class: "head" },
    h("span", { class: "brand" }, t("app-name")),
    demo,
    practice.element,
    who,
    lamps,
    h("div", { class: "tools" }, help, theme, leave),
    stopButton(app),
  );

  const showMe = () => {
    const signedIn = Boolean(app.me?.signed_in);
    demo.hidden = !app.me?.demo;
    help.hidden = !signedIn;
    leave.hidden = !signedIn || Boolean(app.me?.demo);
    lamps.style.visibility = signedIn ? "" : "hidden";
    me.hidden = leave.hidden;
    write(me, me.hidden ? "" : (app.me?.name ?? ""));
  };
  const showShirt = () => {
    if (!app.live.present) return unknown(shirt, "lamp-shirt-unknown", "");
    const alive = app.live.present.shirt.alive;
    const all = app.live.quality.length;
    const good = app.live.quality.filter((quality) => quality === "good").length;
    if (app.live.present.shirt.chosen === false) {
      shirt.className = "lamp off";
      return write(shirt, t("lamp-shirt-none"));
    }
    const estimated = app.live.quality.filter((quality) => quality === "estimated").length;
    shirt.className = `lamp${estimated ? " att long" : alive && good >= all * 0.75 ? "" : " att"}`;
    const key = estimated ? "lamp-shirt-estimated" : "lamp-shirt";
    write(shirt, alive && all ? t(key, { good, all, estimated }) : t("lamp-shirt-silent"));
  };
  const showChair = () => {
    const now = app.live.present;
    if (!now) return unknown(chair, "lamp-chair-unknown", "wide");
    const armed = now.state === "armed";
    const state = now.chair?.state;
    element.classList.toggle("has-chair", Boolean(state));
    const isBad = state === "silent" || state === "fault";
    chair.className = `lamp${isBad ? " att" : armed ? "" : " off"}${state ? " long" : " wide"}`;
    write(
      chair,
      state ? t("lamp-real", { state: t(`lamp-real-${state}`) }) : armed ? t("lamp-armed") : t("lamp-chair"),
    );
  };
  // A demonstration has a mark of its own.
  const showPractice = () => practice.show(app.me?.demo ? null : app.practice);
  for (const event of /** @type {const} */ (["me", "practice"])) app.addEventListener(event, showPractice);
  app.addEventListener("me", showMe);
  app.live.addEventListener("quality", showShirt);
  app.live.addEventListener("tick", showChair);
  app.live.addEventListener("tick", showShirt);
  app.live.addEventListener("connection", () => {
    showShirt();
    showChair();
    help.disabled = leave.disabled = !app.live.connected; // signing out needs the server, and the help is loaded from it
  });
  showMe();
  showShirt();
  showChair();
  // Long words make the header higher: what stands below it follows.
  const below = new ResizeObserver(() =>
    document.documentElement.style.setProperty("--head", `${element.offsetHeight}px`),
  );
  below.observe(element);
  return element;
}

/** Show that the state of a lamp is not known now. @param {HTMLElement} lamp @param {string} key of its words @param {string} width */
function unknown(lamp, key, width) {
  lamp.className = `lamp off unknown ${width}`;
  write(lamp, t(key));
}

/** @param {import("../main.js").App} app */
function themeButton(app) {
  const button = h("button", { type: "button", class: "icon-button" });
  const show = () => {
    const choice = chosenTheme();
    const label = t("theme-label", { theme: t(`theme-${choice}`) });
    set(button, { "aria-label": label, title: label });
    button.replaceChildren(icon(THEME_ICONS[choice], 22));
  };
  button.addEventListener("click", () => {
    app.toasts.show(t("theme-now", { theme: t(`theme-${nextTheme()}`) }));
    show();
  });
  show();
  return button;
}
