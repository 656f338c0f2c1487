/**
 * The shirt: where its signals come from, who is inside, and how every sensor is.
 * @import { EquipmentView, ShirtLayout } from "types/api"
 * @import { Equipment, ShirtKind } from "types/documents"
 * @import { Child } from "types/dom"
 * @typedef {{kind: string, onKind: (kind: string) => void}} FormState what a form shows, and what it tells of that
 * @typedef {"source" | "body" | "head"} CardName
 */
import { failureWords } from "../../api.js";
import { bodyForm, bodyWords } from "./body_form.js";
import { h, put, s, set, write } from "../../widgets/dom.js";
import { headActions, headForm, headWords } from "./head_card.js";
import { jointStrips } from "../../charts/joint_strips.js";
import { jointWithin } from "../../widgets/joint_words.js";
import { bodyLamps, LAMP_BOX, lampSign, QUALITIES } from "./lamps.js";
import { pads } from "../../widgets/pads.js";
import { replacedList } from "../../widgets/replaced_list.js";
import { sensorCard } from "./sensor_card.js";
import { shirtSender } from "./shirt_sender.js";
import { sourceForm, sourceWords } from "./source_form.js";
import { t } from "../../texts.js";

/** @type {ShirtLayout} */
const NO_LAYOUT = { name: "", channels: [], joints: [] }; // before a shirt was chosen: a body without lamps

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal }) {
  const [view, answer] = await Promise.all([app.api.get("/equipment"), app.api.get("/equipment/shirts")]);
  let equipment = /** @type {Equipment} */ (view);
  const shirts = /** @type {ShirtKind[]} */ (answer);
  if (signal.aborted) return;
  const state = h("span", {});
  const counts = h("span", {});
  const lead = h("p", { class: "lead" }, state, " ", counts);
  const left = h("div", { class: "stack" });
  const right = h("div", { class: "stack" });
  // Without a shirt, first the one thing to do; it keeps its side when one has been chosen.
  const columns = h("div", { class: "shirt-columns" }, equipment.shirt ? [left, right] : [right, left]);
  const below = h("div", {});
  const onward = h("a", { class: "btn go" });
  const showOnward = () => {
    const { has_profile: hasProfile = false, obstacle = null } = app.session ?? {};
    const step = hasProfile && obstacle?.page !== "calibrate" ? "drive" : "calibrate";
    onward.href = `#/${step}`;
    write(onward, t(`shirt-${step}`));
    onward.hidden = !equipment.shirt || app.live.present?.shirt.alive === false; // first a shirt that sends
  };
  let drawn = new AbortController(); // aborted when the equipment is drawn again
  let picked = "";
  /** @type {Map<CardName, string>} cards whose form is open, with the choice it shows */
  const open = new Map();

  const replaced = replacedList(app, ["file"], async () => take(await app.api.get("/equipment")));

  const draw = () => {
    drawn.abort();
    drawn = new AbortController();
    signal.addEventListener("abort", () => drawn.abort(), { signal: drawn.signal });
    const { layout } = equipment;
    put(left, lampsCard(layout ?? NO_LAYOUT));
    put(
      below,
      equipment.body?.kind === "visitor" && h("div", { class: "card pad-card" }, pads(app, drawn.signal).element),
      layout &&
        h("section", { class: "card" }, h("h2", {}, t("traces-title")), jointStrips(app.live, layout, drawn.signal)),
    );
    drawRight();
    showWords(equipment.status.message);
    showOnward();
  };
  /** Forms are drawn again only where something differs: what is typed in them would be lost. @param {EquipmentView} answer */
  const take = (answer) => {
    const fresh = /** @type {Equipment} */ (answer);
    const before = equipment;
    equipment = fresh;
    app.toasts.attempt(replaced.show);
    if (keyOf(fresh) !== keyOf(before)) return draw();
    if (formsKeyOf(fresh) !== formsKeyOf(before)) drawRight();
    showWords(equipment.status.message);
  };
  /** @param {ShirtLayout} layout */
  const lampsCard = (layout) => {
    const lamps = bodyLamps(layout, pick);
    const showLamps = () => lamps.show(app.live.quality);
    app.live.addEventListener("quality", showLamps, { signal: drawn.signal });
    showLamps();
    lamps.mark(picked);
    markLamp = lamps.mark;
    return h(
      "section",
      { class: "card" },
      h(
        "h2",
        {},
        t("shirt-sensors"),
        layout.channels.length > 0 && h("span", { class: "quiet small" }, t("shirt-sensors-hint")),
      ),
      lamps.element,
      legend(),
    );
  };
  /** @type {(name: string) => void} */
  let markLamp = () => {};
  /** @param {string} name */
  const pick = (name) => {
    picked = name;
    markLamp(name);
    drawRight();
  };
  let sensorShown = new AbortController();
  const drawRight = () => {
    sensorShown.abort();
    sensorShown = new AbortController();
    drawn.signal.addEventListener("abort", () => sensorShown.abort(), { signal: sensorShown.signal });
    put(
      right,
      pickedSensor(sensorShown.signal),
      sourceCard(),
      equipment.shirt?.kind === "simulator" && bodyCard(),
      headCard(),
      replaced.element,
    );
  };
  /** @param {AbortSignal} until */
  const pickedSensor = (until) => {
    const { channels, joints } = equipment.layout ?? NO_LAYOUT;
    const index = channels.findIndex(({ name }) => name === picked);
    if (index < 0) return null;
    const channel = channels[index];
    const joint = jointWithin(
      joints.find(({ name }) => name === channel.joint) ?? { name: channel.joint, label: channel.joint },
    );
    /** @param {boolean} isUnused */
    const mark = async (isUnused) => {
      const others = equipment.unused.filter((name) => name !== picked);
      await use(app.api.put("/equipment/unused", { channels: isUnused ? [...others, picked] : others })).catch(
        (error) => {
          app.toasts.show(failureWords(error));
          drawRight();
        },
      );
    };
    return sensorCard(app, { channel, index, joint, isUnused: equipment.unused.includes(picked), signal: until }, mark);
  };
  /** @param {Promise<EquipmentView>} call @param {CardName} [card] whose form made it */
  const use = async (call, card) => {
    const answer = await call;
    const isDone = card && open.delete(card);
    take(answer);
    if (!isDone) return;
    drawRight();
    right.querySelector(`[data-card="${card}"]`)?.scrollIntoView({ block: "nearest" }); // the page has become shorter
  };
  /**
   * A card that says what is in use; its form stays open, and as it is, when the page is drawn again.
   * @param {CardName} name @param {string} words @param {string} first the choice that the form begins with
   * @param {(shown: FormState) => HTMLElement} makeForm
   */
  const card = (name, words, first, makeForm) =>
    summary(
      name,
      words,
      open.has(name),
      (isOpen) => {
        if (!isOpen) open.delete(name);
        else if (!open.has(name)) open.set(name, first);
      },
      () => makeForm({ kind: open.get(name) ?? first, onKind: (kind) => open.set(name, kind) }),
    );
  if (!equipment.shirt) open.set("source", ""); // choosing a shirt is the next step
  const sourceCard = () => {
    const element = card("source", sourceWords(equipment.shirt, shirts), equipment.shirt?.kind ?? "", (shown) =>
      sourceForm(app, equipment, shirts, (config) => use(app.api.put("/equipment/shirt", config), "source"), shown),
    );
    if (shirts.some(({ kind, network }) => network && kind === equipment.shirt?.kind))
      element.append(shirtSender(app, sensorShown.signal));
    return element;
  };
  const bodyCard = () =>
    card("body", equipment.body ? bodyWords(equipment.body) : "", "", (shown) =>
      bodyForm(app, equipment, (config) => use(app.api.put("/equipment/body", config), "body"), shown),
    );
  const headCard = () => {
    const words = [headWords(equipment.head.config), equipment.head.config && equipment.head.message]
      .filter(Boolean)
      .join(" ");
    const element = card("head", words, equipment.head.config?.kind ?? "none", (shown) =>
      headForm(app, equipment, (config) => use(app.api.put("/equipment/head", { config }), "head"), shown),
    );
    const actions = headActions(app, equipment.head);
    if (actions) element.append(actions);
    return element;
  };
  /** @param {string} words the state of the shirt */
  const showWords = (words) => {
    const all = app.live.quality.length;
    const good = app.live.quality.filter((quality) => quality === "good").length;
    const lost = app.live.latest?.shirt.lost ?? 0;
    const sentence = equipment.shirt ? words : t("shirt-none");
    const isNews = withoutFigures(sentence) !== withoutFigures(state.textContent);
    set(state, { "aria-live": isNews ? "polite" : "off" }); // a screen reader is silent about figures that count
    write(state, sentence);
    const figures = [all ? t("shirt-words-count", { good, all }) : "", lost ? t("shirt-lost", { count: lost }) : ""];
    write(counts, figures.filter(Boolean).join(" "));
  };
  /** @param {CustomEvent<string>} event */
  const readAgain = async ({ detail }) => {
    if (detail === "equipment" || detail === "everything")
      take(await app.api.get("/equipment").catch(() => /** @type {EquipmentView} */ (equipment)));
  };
  const follow = () => {
    showWords(app.live.shirtWords);
    showOnward();
  };
  app.live.addEventListener("quality", follow, { signal });
  app.addEventListener("session", showOnward, { signal });
  app.live.addEventListener("changed", readAgain, { signal });
  app.addEventListener("equipment", ({ detail }) => take(detail), { signal });

  put(
    root,
    h("div", { class: "body" }, h("h1", { tabindex: "-1" }, t("shirt-title")), lead, columns, below),
    h("div", { class: "foot" }, h("span", { class: "grow" }), onward),
  );
  draw();
}

/** @param {string} words */
const withoutFigures = (words) => words.replace(/\d+/g, "");

/** A key of the parts that need the whole page drawn again. @param {Equipment} equipment */
function keyOf({ shirt, body, layout, unused }) {
  return JSON.stringify([shirt, body, layout, unused]);
}

/** A key of what only the cards and their forms show. @param {Equipment} equipment */
function formsKeyOf({ head, files, shirt_keys }) {
  return JSON.stringify([head, files, shirt_keys]);
}

/**
 * @param {CardName} name @param {Child} words @param {boolean} isOpen @param {(isOpen: boolean) => void} onToggle
 * @param {() => HTMLElement} makeForm called when it is opened first
 */
function summary(name, words, isOpen, onToggle, makeForm) {
  const place = h("div", {});
  const details = h("details", { open: isOpen }, h("summary", {}, t("source-change")), place);
  const fillIn = () => details.open && !place.firstChild && put(place, makeForm());
  details.addEventListener("toggle", () => {
    onToggle(details.open);
    fillIn();
  });
  fillIn();
  return h(
    "section",
    { class: "card", "data-card": name },
    h("h2", {}, t(`${name}-title`)),
    h("p", {}, words),
    details,
  );
}

function legend() {
  return h(
    "details",
    { class: "lamp-legend" },
    h("summary", {}, t("shirt-legend")),
    h(
      "dl",
      {},
      Object.keys(QUALITIES).map((quality) => [
        h(
          "dt",
          {},
          s(
            "svg",
            { viewBox: LAMP_BOX, width: 22, height: 22, "aria-hidden": "true" },
            s("g", { class: "sensor", "data-quality": quality }, lampSign(quality)),
          ),
          t(`quality-${quality}`),
        ),
        h("dd", {}, t(`quality-${quality}-words`)),
      ]),
    ),
  );
}
