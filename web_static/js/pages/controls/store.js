/**
 * The controls as they are being edited: changes show at once, are sent when the hand rests, and go back when refused.
 * @import { Binding, ControlSettings, ControlsView, Gesture } from "types/api"
 * @typedef {ReturnType<typeof controlsStore>} ControlsStore
 * @typedef {Binding["control"]} Control
 * @typedef {Required<ControlSettings>} Settings
 */
import { failureWords } from "../../api.js";
import { onNews } from "../../live/news.js";
import { computed, signal } from "../../preact.js";
import { busyKind } from "../../shell/busy.js";
import { OTHER_SESSION } from "../../shell/other_session.js";
import { t } from "../../texts.js";
import { gestureFor, jointLabels, newGestureName } from "../../widgets/gestures.js";
import { ask as askPerson } from "../../widgets/question.js";

const REST = 400; // ms without another change, then it is sent
const LEAST_GAP = 0.02; // FS/s or FS

/**
 * @param {import("../../main.js").App} app @param {ControlsView} first what GET /controls answered
 * @param {AbortSignal} left of the page
 */
export function controlsStore(app, first, left) {
  const { api } = app; // names the session of this page, also in what is sent when the page is left
  const view = signal(first);
  const settings = signal(settingsOf(first)); // with the changes that are not sent yet
  const live = signal(app.live.latest);
  const busy = computed(() => busyKind(live.value));
  const labels = computed(() => jointLabels(view.value.parameters.profile));
  const state = signal(""); // whether the changes are saved
  const problem = signal(""); // why a change was refused
  const suggestion = signal(""); // the reason of the suggestion that was taken last
  let timer = 0; // until the changes are sent; 0: none wait
  let sending = Promise.resolve();
  let reads = 0;

  /** @param {ControlsView} answer */
  const take = (answer) => {
    view.value = answer;
    settings.value = settingsOf(answer);
    problem.value = "";
  };
  /** Do this after what is being sent. @param {() => Promise<void>} act */
  const inTurn = (act) => {
    const done = sending.then(act);
    sending = done.catch(() => {});
    return done;
  };
  /** @param {Settings} body */
  const put = async (body) => {
    try {
      const answer = await api.put("/controls", body);
      if (timer) view.value = answer;
      else take(answer);
      state.value = t("controls-saved");
    } catch (error) {
      drop();
      take(view.value);
      state.value = "";
      problem.value = failureWords(error);
    }
  };
  const drop = () => {
    clearTimeout(timer);
    timer = 0;
  };
  /** Send the changes that wait, at once. */
  const flush = () => {
    if (!timer) return sending;
    drop();
    const body = settings.value;
    return inTurn(() => put(body));
  };
  /** @param {Settings} next */
  const change = (next) => {
    settings.value = next;
    problem.value = "";
    state.value = t("controls-saving");
    clearTimeout(timer);
    timer = setTimeout(flush, REST);
  };

  /** Load another set, undo or the like, after the changes that wait. @param {() => Promise<ControlsView>} request */
  const ask = (request) => {
    flush();
    return inTurn(async () => take(await request()));
  };
  /**
   * Do it, and show a refusal in the foot.
   * @param {() => Promise<ControlsView>} request
   * @param {boolean} [saysWhy] whether the reason of the suggestion is shown
   */
  const attempt = async (request, saysWhy = false) => {
    problem.value = "";
    try {
      await ask(request);
      suggestion.value = saysWhy ? view.value.suggested.reason : "";
    } catch (error) {
      problem.value = failureWords(error);
    }
  };
  const undo = () => attempt(() => api.post("/controls/undo"));
  const redo = () => attempt(() => api.post("/controls/redo"));
  const suggest = async () => {
    const answer = await askPerson(app.question, t("controls-suggest-ask"), [
      { value: "suggest", label: t("controls-suggest-go"), kind: "btn go" },
      { value: null, label: t("cancel") },
    ]);
    if (answer && !left.aborted) await attempt(() => api.post("/controls/suggest"), true);
  };
  /** @param {string} title of a saved set */
  const load = (title) => ask(() => api.post("/controls/load", { title }));
  /** Save what is set under a name; whether it was accepted. @param {string} title */
  const save = async (title) => {
    change({ ...settings.value, title });
    await flush();
    return view.value.parameters.title === title;
  };

  /** @param {string} name @param {Partial<Gesture>} part */
  const setGesture = (name, part) => {
    const gestures = settings.value.gestures.map((one) => (one.name === name ? { ...one, ...part } : one));
    change({ ...settings.value, gestures });
  };
  /** @param {string} name of a gesture @param {number} from @param {number} full */
  const setHandles = (name, from, full) =>
    setGesture(name, {
      dead_zone: Number(from.toFixed(4)),
      full: Number(Math.max(full, from + LEAST_GAP).toFixed(4)),
    });
  /** @param {Control} control @returns {Binding} */
  const bindingOf = (control) =>
    settings.value.bindings.find((one) => one.control === control) ?? { control, gestures: [], gain: 1 };
  /** @param {Control} control @returns {Gesture[]} */
  const gesturesOf = (control) =>
    bindingOf(control).gestures.flatMap((name) => settings.value.gestures.find((one) => one.name === name) ?? []);
  /** The settings with another binding of its control. @param {Binding} binding @returns {Settings} */
  const withBinding = (binding) => {
    const { bindings } = settings.value;
    const place = bindings.findIndex(({ control }) => control === binding.control);
    return { ...settings.value, bindings: place < 0 ? [...bindings, binding] : bindings.with(place, binding) };
  };
  /** @param {string} name of a gesture @param {Gesture["feature"]} feature */
  const setFeature = (name, feature) => setGesture(name, { feature });
  /** @param {Control} control @param {number} gain */
  const setGain = (control, gain) => change(withBinding({ ...bindingOf(control), gain }));
  /** @param {Control} control @param {string} name of the gesture */
  const unbind = (control, name) => {
    const binding = bindingOf(control);
    change(withBinding({ ...binding, gestures: binding.gestures.filter((one) => one !== name) }));
  };
  /** @param {Control} control @param {string} joint @param {1 | -1} direction */
  const bind = (control, joint, direction) => {
    const gesture = gestureFor(settings.value.gestures, joint, direction) ?? newGesture(joint, direction);
    if (!gesture) return;
    const binding = bindingOf(control);
    const { gestures, ...others } = withBinding({ ...binding, gestures: [...binding.gestures, gesture.name] });
    change({ ...others, gestures: gestures.includes(gesture) ? gestures : [...gestures, gesture] });
  };
  /**
   * A gesture with the thresholds of the other direction, otherwise with those of the calibration.
   * @param {string} joint @param {1 | -1} direction @returns {Gesture | null}
   */
  const newGesture = (joint, direction) => {
    const jointMap = view.value.parameters.profile.joints.find(({ name }) => name === joint);
    const like =
      gestureFor(settings.value.gestures, joint, -direction) ?? (jointMap && (jointMap[jointMap.map] ?? jointMap.pca));
    if (!like) return null;
    const { dead_zone, full } = like;
    return { name: newGestureName(joint, direction), joint, direction, feature: "rate", dead_zone, full };
  };

  /** Read the controls again after a change from elsewhere; changes of this page come first. */
  const readAgain = async () => {
    if (timer) return;
    const [read, before] = [++reads, sending];
    await before;
    const now = await api.get("/controls");
    if (timer || sending !== before || read !== reads) return;
    const { hash, obstacle } = view.value;
    if (now.hash !== hash || now.obstacle?.message !== obstacle?.message) take(now);
  };
  app.live.addEventListener("tick", ({ detail }) => (live.value = detail), { signal: left });
  onNews(app, left, { what: ["controls", "equipment"] }, () => readAgain().catch(() => null));
  app.addEventListener("drafts", ({ detail }) => timer && detail.push(t("controls-draft")), { signal: left });
  left.addEventListener("abort", () => (left.reason === OTHER_SESSION ? drop() : flush()));
  const signals = { view, settings, live, busy, labels, state, problem, suggestion };
  const changes = { change, undo, redo, suggest, load, save, setHandles, setFeature, setGain, bind, unbind };
  return { app, left, ...signals, ...changes, bindingOf, gesturesOf };
}

/** What can be set: the parameters without the profile. @param {ControlsView} view @returns {Settings} */
function settingsOf({ parameters: { profile: _, ...settings } }) {
  return settings;
}
