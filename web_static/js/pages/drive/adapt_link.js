/** A small link to what would change, or has changed, of the map after a trial; nothing while there is neither. */
import { concerns } from "../../live/news.js";
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";

/** @param {import("../../main.js").App} app @param {import("types/api").TrialDetail} trial @param {AbortSignal} signal */
export function adaptLink(app, trial, signal) {
  const link = h("a", { class: "btn bare", href: "#/adapt", hidden: true });
  const read = async () => {
    if (trial.patient_id !== app.session?.patient?.id) return;
    const proposal = (await app.api.get("/adaptation").catch(() => null))?.proposal;
    const own = proposal?.changes && proposal.trials.includes(trial.id) ? proposal : null; // of this trial
    link.hidden = !own;
    if (own) write(link, t(own.applied === null ? "adapt-link-proposed" : "adapt-link-applied"));
  };
  app.live.addEventListener(
    "changed",
    ({ detail }) => concerns(detail, { what: ["adaptation"], patient: trial.patient_id }) && read(),
    { signal },
  );
  read();
  return link;
}
