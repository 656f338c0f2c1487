/**
 * A small link to what would change, or has changed, of the map after a trial; nothing while there is neither.
 * @import { AdaptationView, TrialDetail } from "types/api"
 */
import { onNews } from "../../live/news.js";
import { h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { useUntilGone } from "../../widgets/made.js";

/** @param {{app: import("../../main.js").App, trial: TrialDetail, left: AbortSignal}} link */
export function AdaptLink({ app, trial, left }) {
  const proposal = useSignal(/** @type {AdaptationView["proposal"]} */ (null));
  useUntilGone(left, (signal) => {
    const read = async () => {
      if (trial.patient_id !== app.session?.patient?.id) return;
      proposal.value = (await app.api.get("/adaptation").catch(() => null))?.proposal ?? null;
    };
    onNews(app, signal, { what: ["adaptation"], patient: trial.patient_id }, read);
    read();
  });
  const now = proposal.value;
  const own = now?.changes && now.trials.includes(trial.id) ? now : null; // of this trial
  return h(
    "a",
    { class: "btn bare", href: "#/adapt", hidden: !own },
    own && t(own.applied === null ? "adapt-link-proposed" : "adapt-link-applied"),
  );
}
