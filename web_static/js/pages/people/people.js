/**
 * People, for owners: who may use this clinic; invite, choose rights, make a link for a new password, disable, enable.
 * @import { LinkView, PatientView, PersonView } from "types/api"
 */
import { ApiError, FORBIDDEN } from "../../api.js";
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { moment } from "../../widgets/format.js";
import { icon } from "../../widgets/icons.js";
import { linkCard } from "./link_card.js";
import { rowList } from "../../widgets/list.js";
import { rightsForm } from "./rights_form.js";

const LOOK_EVERY = 10_000; // ms

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal, rest }) {
  if (app.me?.role !== "owner") throw new ApiError(t("people-owner"), FORBIDDEN);
  let [people, patients] = await Promise.all([app.api.get("/people"), app.api.get("/patients")]);
  if (signal.aborted) return;
  const list = rowList("people");
  const above = h("div", {});

  const read = async () => {
    const found = await Promise.all([app.api.get("/people"), app.api.get("/patients")]);
    if (signal.aborted || JSON.stringify(found) === JSON.stringify([people, patients])) return;
    [people, patients] = found;
    draw();
  };
  const close = () =>
    put(
      above,
      h("button", { type: "button", class: "btn go", onclick: openForm }, icon("plus", 20), t("people-invite")),
    );
  /** @param {LinkView} link */
  const showLink = async (link) => {
    put(above, linkCard(app, link, close));
    above.querySelector("h2")?.focus();
    above.scrollIntoView({ block: "nearest" });
    await read();
  };
  const openForm = () => {
    put(
      above,
      rightsForm(patients, null, {
        send: async (rights) => showLink(await app.api.post("/people", rights)),
        onClose: close,
      }),
    );
    above.querySelector("input")?.focus();
  };
  /** @param {PersonView} person */
  const change = (person) => {
    /** @param {{role: PersonView["role"], patients: number[] | null}} rights */
    const send = async ({ role, patients: shown }) => {
      await app.api.put(`/people/${person.id}`, { role, patients: shown });
      close();
      await read();
    };
    put(above, rightsForm(patients, people.find(({ id }) => id === person.id) ?? person, { send, onClose: close }));
    above.scrollIntoView({ block: "nearest" });
    above.querySelector("input")?.focus();
  };
  /** @param {() => Promise<unknown>} act */
  const attempt = (act) => app.toasts.attempt(async () => (await act(), await read()));
  const actions = {
    change,
    /** @param {PersonView} person */
    link: (person) => app.toasts.attempt(async () => showLink(await app.api.post(`/people/${person.id}/link`))),
    /** @param {PersonView} person */
    disable: (person) => attempt(() => app.api.post(`/people/${person.id}/disable`)),
    /** @param {PersonView} person */
    enable: (person) => attempt(() => app.api.post(`/people/${person.id}/enable`)),
  };
  const draw = () => list.show(people.map((person) => row(person, patients, actions)));
  draw();
  close();
  const timer = setInterval(() => read().catch(() => null), LOOK_EVERY); // others accept invitations meanwhile
  signal.addEventListener("abort", () => clearInterval(timer));
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("rail-people")),
      h("p", { class: "lead" }, t("people-lead")),
      h("div", { class: "above-list" }, above),
      list,
      h("p", { class: "after-list" }, h("a", { class: "btn small", href: "#/settings" }, t("people-back"))),
    ),
  );
  if (rest[0] === "invite") openForm();
}

/**
 * @param {PersonView} person @param {PatientView[]} patients
 * @param {Record<"change" | "link" | "disable" | "enable", (person: PersonView) => void>} actions
 */
function row(person, patients, actions) {
  /** @param {"change" | "link" | "disable" | "enable"} what */
  const button = (what) => {
    const key = what === "link" && person.state === "invited" ? "people-link-again" : `people-${what}`;
    const label = t(`${key}-label`, { name: person.name });
    return h(
      "button",
      { type: "button", class: "btn small", "aria-label": label, onclick: () => actions[what](person) },
      t(key),
    );
  };
  const isDisabled = person.state === "disabled";
  return h(
    "div",
    { class: `card person member ${person.state}` },
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
