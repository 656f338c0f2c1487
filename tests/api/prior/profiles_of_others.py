"""Profiles whose maps come from other people, as a calibration of the test's application results in them."""

from typing import Any

from fake_clinic import profile_for

from app.calibration.profile import RATE_LAGS, CalibrationProfile, MapCheck, PriorMap
from app.layout import ShirtLayout

CHECK = MapCheck(in_phase=0.95, hit_rate=0.7, false_per_minute=1.0, false_count=1)


def profile_of_others(layout: ShirtLayout, repetitions: int = 0, **of_prior: Any) -> CalibrationProfile:
    """Return a profile in which every joint drives by other people, with so many own repetitions."""
    profile = profile_for(layout)
    joints = []
    for joint in profile.joints:
        part = (0.1,) * len(joint.channels)
        linear = {"rate": part, "earlier": (part,) * (len(RATE_LAGS) - 1), "short": part, "long": part}
        prior = PriorMap(**linear, dead_zone=0.2, full=1.0, people=8, repetitions=repetitions, **of_prior)
        joints.append(joint.model_copy(update={"map": "prior", "prior": prior, "prompted": repetitions > 0}))
    return profile.model_copy(update={"joints": tuple(joints)})
