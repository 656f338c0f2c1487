/**
 * People, for owners: who may use this clinic; invite, choose rights, make a link for a new password, disable, enable.
 * @import { LinkView, PatientView, PersonView } from "types/api"
 */
import { ApiError, FORBIDDEN } from "../../api.js";
import { drawPage, Fragment, h, signal, useOpening } from "../../preact.js";
import { t } from "../../texts.js";
import { moment } from "../../widgets/format.js";
import { Icon } from "../../widgets/icons.js";
import { LinkCard } from "./link_card.js";
import { RightsForm } from "./rights_form.js";

const LOOK_EVERY = 10_000; // ms

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal: left, rest }) {
  if (app.me?.role !== "owner") throw new ApiError(t("people-owner"), FORBIDDEN);
  const ask = () => Promise.all([app.api.get("/people"), app.api.get("/patients")]);
  const lists = signal(await ask());
  if (left.aborted) return;
  // What is open above the list: a link, or the form for the rights of one person; null is somebody new.
  const opened = signal(/** @type {{link: LinkView} | {person: PersonView | null} | null} */ (null));
  const read = async () => void (lists.value = await ask());
  const close = () => void (opened.value = null);
  const invite = () => void (opened.value = { person: null });
  /** @param {LinkView} link */
  const showLink = async (link) => {
    opened.value = { link };
    await read();
  };
  /** @param {() => Promise<unknown>} act */
  const attempt = (act) => app.toasts.attempt(async () => (await act(), await read()));
  /** @type {Actions} */
  const actions = {
    change: (person) => void (opened.value = { person }),
    link: (person) => app.toasts.attempt(async () => showLink(await app.api.post(`/people/${person.id}/link`))),
    disable: (person) => attempt(() => app.api.post(`/people/${person.id}/disable`)),
    enable: (person) => attempt(() => app.api.post(`/people/${person.id}/enable`)),
  };

  const Above = () => {
    const now = opened.value;
    const place = useOpening(now, "h2[tabindex], input");
    return h("div", { ref: place }, now ? opening(now) : button());
  };
  const button = () =>
    h(
      "button",
      { type: "button", class: "btn go", onClick: invite },
      h(Icon, { name: "plus", size: 20 }),
      t("people-invite"),
    );
  /** @param {NonNullable<typeof opened.value>} now */
  const opening = (now) => {
    if ("link" in now) return h(LinkCard, { app, link: now.link, onDone: close });
    const { person } = now;
    return h(RightsForm, {
      key: person?.id ?? "new",
      patients: lists.value[1],
      person,
      send: async ({ name, role, patients }) => {
        if (!person) return showLink(await app.api.post("/people", { name, role, patients }));
        await app.api.put(`/people/${person.id}`, { role, patients });
        close();
        await read();
      },
      onClose: close,
    });
  };
  const List = () => {
    const [people, patients] = lists.value;
    return h(
      "div",
      { class: "people", role: "list" },
      people.map((person) => h(Row, { key: person.id, person, patients, actions })),
    );
  };

  drawPage(
    root,
    h(
      Fragment,
      {},
      h("h1", { tabindex: -1 }, t("rail-people")),
      h("p", { class: "lead" }, t("people-lead")),
      h("div", { class: "above-list" }, h(Above, {})),
      h(List, {}),
      h("p", { class: "after-list" }, h("a", { class: "btn small", href: "#/settings" }, t("people-back"))),
    ),
  );
  const timer = setInterval(() => read().catch(() => null), LOOK_EVERY); // others accept invitations meanwhile
  left.addEventListener("abort", () => clearInterval(timer));
  if (rest[0] === "invite") invite();
}

/** @typedef {Record<"change" | "link" | "disable" | "enable", (person: PersonView) => unknown>} Actions */

/** @param {{person: PersonView, patients: PatientView[], actions: Actions}} row */
function Row({ person, patients, actions }) {
  /** @param {keyof Actions} what */
  const button = (what) => {
    const key = what === "link" && person.state === "invited" ? "people-link-again" : `people-${what}`;
    const label = t(`${key}-label`, { name: person.name });
    return h(
      "button",
      { type: "button", class: "btn small", "aria-label": label, onClick: () => actions[what](person) },
      t(key),
    );
  };
  const isDisabled = person.state === "disabled";
  return h(
    "div",
    { class: `card person member ${person.state}`, role: "listitem" },
    h(
      "div",
      { class: "grow" },
      h("b", {}, person.name),
      person.is_you && h("span", { class: "tag calm" }, t("people-you")),
      h("div", { class: "quiet" }, `${t(`people-role-${person.role}`)}${shownWords(person, patients)}`),
      person.state !== "active" && h("div", { class: "small" }, stateWords(person)),
    ),
    h(
      "div",
      { class: "spread" },
      !isDisabled && button("change"),
      !isDisabled && button("link"),
      isDisabled ? button("enable") : !person.is_you && button("disable"),
    ),
  );
}

/** @param {PersonView} person */
function stateWords({ state, link_until: until }) {
  if (state === "disabled") return t("people-state-disabled");
  return until ? t("people-state-invited", { until: moment(until) }) : t("people-state-expired");
}

/** @param {PersonView} person @param {PatientView[]} patients */
function shownWords({ patients: shown, role }, patients) {
  if (role !== "reviewer") return "";
  if (!shown) return ` · ${t("people-patients-all")}`;
  const codes = patients.filter(({ id }) => shown.includes(id)).map(({ code }) => code);
  return ` · ${codes.length ? codes.join(", ") : t("people-patients-nobody")}`;
}
