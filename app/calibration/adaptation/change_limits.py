"""How far an adaptation may change a map (docs/learning/adapting.md, "The rule")."""

from dataclasses import dataclass

from app.calibration.map_grades import EVR_LIMITS


@dataclass(frozen=True, slots=True)
class ChangeLimits:
    """Limits of the change of a map in one adaptation, small enough for a person to adapt to."""

    per_trial_deg: float = 2.0
    per_update_deg: float = 5.0
    least_evr: float = EVR_LIMITS[0]
    largest_angle_deg: float = 30.0  # from the calibration's direction
    cross_talk_slack: float = 0.01  # smaller differences of the share are within chance
    warn: float = 0.05  # felt change from which on the proposal warns
    refuse: float = 0.10  # felt change from which on a joint's change is refused
    least_movement: float = 3.0  # s of the joint's own movement, from which its direction is estimated
    worth_it_deg: float = 0.5  # smaller turns are chance and make no new version


STANDARD_LIMITS = ChangeLimits()
