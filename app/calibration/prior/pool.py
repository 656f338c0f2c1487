"""Puts several priors of one layout together, and lets them decode where a person has nothing of the own yet."""

from collections.abc import Mapping, Sequence
from typing import TypeVar

from app.calibration.prior.arrangement import RingMoments
from app.calibration.prior.map_prior import JointPrior, MapPrior, check_layout
from app.calibration.profile import CalibrationProfile

Summed = TypeVar("Summed", JointPrior, RingMoments)


def together(priors: Sequence[MapPrior]) -> MapPrior:
    """Return the sum of at least one prior; raise PriorError when their layouts differ."""
    first, *others = priors
    joints, rings = dict(first.joints), dict(first.rings)
    for other in others:
        check_layout(other.layout, first.layout)
        joints = {name: _sum(joints, other.joints, name) for name in joints | dict(other.joints)}
        rings = {name: _sum(rings, other.rings, name) for name in rings | dict(other.rings)}
    return MapPrior(first.layout, joints, rings)


def decoded_by_others(profile: CalibrationProfile) -> CalibrationProfile:
    """Return the profile with the map learnt from other people in use for each joint that was never prompted."""
    joints = tuple(
        joint.model_copy(update={"map": "prior"}) if joint.prior is not None and not joint.prompted else joint
        for joint in profile.joints
    )
    return profile.model_copy(update={"joints": joints})


def _sum(some: Mapping[str, Summed], others: Mapping[str, Summed], name: str) -> Summed:
    if name not in some:
        return others[name]
    return some[name] + others[name] if name in others else some[name]
