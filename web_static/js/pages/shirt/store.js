/**
 * What the page of the shirt shows: the equipment, how the sensors are now, and which one is picked.
 * @import { EquipmentView } from "types/api"
 * @import { Equipment, ShirtKind } from "types/documents"
 * @typedef {ReturnType<typeof shirtStore>} ShirtStore
 */
import { failureWords } from "../../api.js";
import { movingNow } from "../../live/moving_channels.js";
import { onNews } from "../../live/news.js";
import { signal } from "../../preact.js";
import { t } from "../../texts.js";
import { replacedList } from "../../widgets/replaced_list.js";

/**
 * @param {import("../../main.js").App} app @param {EquipmentView} first @param {ShirtKind[]} kinds the shirts to choose from
 * @param {AbortSignal} left of the page
 */
export function shirtStore(app, first, kinds, left) {
  const equipment = signal(/** @type {Equipment} */ (first));
  const readLive = () => ({
    qualities: app.live.quality,
    noise: app.live.noise,
    lost: app.live.latest?.shirt.lost ?? 0,
    arrivals: app.live.arrivals,
    isSending: app.live.present?.shirt.alive !== false,
    session: app.session,
  });
  const live = signal(readLive());
  const sentence = signal(""); // the state of the shirt
  const { moving, most } = movingNow(app.live, left);
  const picked = signal(""); // name of a channel
  const read = async () => take(await app.api.get("/equipment"));
  const replaced = replacedList(app, ["file"], read);
  /** @param {string} words */
  const setState = (words) => void (sentence.value = equipment.value.shirt ? words : t("shirt-none"));
  /** @param {EquipmentView} view */
  const take = (view) => {
    equipment.value = /** @type {Equipment} */ (view);
    setState(view.status.message);
    app.toasts.attempt(replaced.read);
  };
  /** @param {string} name of a channel @param {boolean} isUnused */
  const setUnused = async (name, isUnused) => {
    const others = equipment.value.unused.filter((other) => other !== name);
    try {
      take(await app.api.put("/equipment/unused", { channels: isUnused ? [...others, name] : others }));
    } catch (error) {
      app.toasts.show(failureWords(error));
      equipment.value = { ...equipment.value }; // so that the switch stands as before
    }
  };
  const follow = () => void (live.value = readLive());
  setState(first.status.message);
  app.live.addEventListener("quality", () => (follow(), setState(app.live.shirtWords)), { signal: left });
  app.addEventListener("session", follow, { signal: left });
  onNews(app, left, { what: ["equipment"] }, () => read().catch(() => null));
  app.addEventListener("equipment", ({ detail }) => take(detail), { signal: left });
  const { ReplacedList } = replaced;
  return { app, left, kinds, equipment, live, sentence, moving, most, picked, ReplacedList, take, setUnused };
}
