"""Whether a person's own movements agree with maps that are learnt from other people, as a real chair needs it."""

from app.calibration.linear_map import LinearMap
from app.calibration.vocabulary import DriveParameters
from app.texts import Text

LEAST_IN_PHASE = 0.8  # of the activation of the person's own repetitions: the direction is right
LEAST_HIT = 0.3  # of the time of the person's own movements with activation: the size is right


def joints_without_own_movement(parameters: DriveParameters) -> list[Text | str]:
    """Return what people call the bound joints whose direction no own repetition has confirmed."""
    called = parameters.profile.layout.joints_within
    joints = {joint.name: joint for joint in parameters.profile.joints}
    bound = {parameters.gestures[i].joint for i in parameters.bound_gestures}
    return [
        called[name]
        for name, joint in joints.items()
        if name in bound and (joint.map == "prior" or not joint.prompted) and not (joint.prior and agrees(joint.prior))
    ]


def agrees(prior: LinearMap) -> bool:
    """Return whether at least one prompted repetition of the person's own agrees with the map in direction and size."""
    check = prior.check
    return check is not None and check.in_phase >= LEAST_IN_PHASE and check.hit_rate >= LEAST_HIT


def own_movement_refusal(parameters: DriveParameters) -> Text | None:
    """Return in a sentence what is missing before a real chair; None when nothing is."""
    missing = joints_without_own_movement(parameters)
    return Text("calibration-not-confirmed", joints=missing) if missing else None
