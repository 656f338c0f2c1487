/**
 * Where a page leads that would lead to driving, while the patient's controls cannot drive in the shirt in use.
 * @import { EquipmentView, ObstacleView } from "types/api"
 */
import { t } from "../../texts.js";

/**
 * The way to what is missing, and the sentence that says what; null when a trial can be started.
 * @param {EquipmentView["shirt"]} shirt @param {ObstacleView | null} obstacle
 */
export function wayBeforeDriving(shirt, obstacle) {
  if (!shirt) return { href: "#/shirt", go: t("drive-no-shirt-go"), message: t("drive-no-shirt") };
  return (
    obstacle && { href: `#/${obstacle.page}`, go: t(`drive-obstacle-${obstacle.page}`), message: obstacle.message }
  );
}
