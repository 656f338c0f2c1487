/** Begin the trial that is proposed for the patient, without a look at the Drive page. */
import { chooseView } from "../../view/view_bar.js";
import { canDrawIn3d } from "../../view/webgl.js";

/** With a real chair in use this leads to the page of that chair instead. @param {import("../../main.js").App} app @param {number} patient id */
export async function beginNextTask(app, patient) {
  const [chairs, { floorplan, path }] = await Promise.all([
    app.api.get("/chairs"),
    app.api.get(`/patients/${patient}/next-task`),
  ]);
  if (chairs.chosen !== null) return app.go("#/drive");
  if (!canDrawIn3d()) chooseView("plan");
  app.requestTrial({ floorplan, path });
}
