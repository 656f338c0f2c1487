"""Fits a calibration of an earlier day to the shirt as it sits today, from ten seconds of free movement."""

import numpy as np
from numpy.typing import NDArray

from app.calibration.adaptation.donning_range import fit_ranges
from app.calibration.adaptation.movement import Movement
from app.calibration.gaps import without_gaps
from app.calibration.linear_map import Arrangement, LinearMap
from app.calibration.prior.map_prior import MapPrior
from app.calibration.prior.prior_map import find_arrangements
from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import DriveParameters
from app.texts import Text

OTHER_RATE = Text("calibration-fit-rate")


class DonningError(ValueError):
    """The calibration cannot be fitted to the shirt as it sits; the message says why, and what to do."""


def fit_to_donning(
    parameters: DriveParameters,
    calibrated: CalibrationProfile,
    free: NDArray[np.floating],
    sample_rate: float,
    prior: MapPrior | None = None,
) -> DriveParameters:
    """Return the parameters for the shirt as it sits in ten seconds of free movement.

    Only the ranges of the channels and their means follow (`donning_range.py`). Weights, thresholds and controls stay,
    because a new donning hardly changes what a map reads (docs/learning/adapting.md, "Does it help?"). A ring of
    sensors that is turned on the limb would change it, so that it is refused.

    Parameters
    ----------
    parameters : DriveParameters
        The set in use, in the same layout.
    calibrated : CalibrationProfile
        The calibration that its map comes from.
    free : (n, n_channels) array
        Frames of free movement, signal units.
    sample_rate : float
        Of these frames, Hz.
    prior : MapPrior, optional
        Other people in the same shirt, who tell how a ring of sensors sits.

    Raises
    ------
    DonningError
        When the frames come at another rate, or a ring is turned against the calibration.
    """
    profile = parameters.profile
    if abs(sample_rate - profile.sample_rate) > 0.01 * profile.sample_rate:
        raise DonningError(OTHER_RATE)
    if prior is not None:
        _refuse_turned_rings(profile, find_arrangements(prior, without_gaps(free, sample_rate), sample_rate))
    still = np.zeros(len(free), dtype=np.bool_)
    fitted = fit_ranges(profile, Movement(free, sample_rate, still), calibrated)
    return parameters.model_copy(update={"profile": fitted})


def joints_followed(before: CalibrationProfile, after: CalibrationProfile) -> list[str]:
    """Return the joints some of whose ranges differ between two profiles of one layout."""
    moved = (np.array(before.low) != np.array(after.low)) | (np.array(before.high) != np.array(after.high))
    return [joint.name for joint in before.joints if moved[list(joint.channels)].any()]


def _refuse_turned_rings(profile: CalibrationProfile, today: dict[str, Arrangement]) -> None:
    """Refuse a ring that sits otherwise than when it was calibrated, where the calibration compared it with others."""
    names = profile.layout.joints_within
    priors: dict[str, LinearMap] = {joint.name: joint.prior for joint in profile.joints if joint.prior is not None}
    for ring, arrangement in today.items():
        if ring not in profile.layout.rings:  # it was calibrated before the layout named this ring
            continue
        sensors = profile.layout.rings[ring]
        joint = profile.layout.channels[sensors[0]].joint
        if joint not in priors:
            continue
        prior = priors[joint]
        then = {**prior.arrangement, **prior.as_worn}.get(ring, Arrangement())
        if arrangement.mirrored != then.mirrored:
            raise DonningError(Text("calibration-fit-mirrored", joint=names[joint]))
        if arrangement.shift != then.shift:
            count = len(sensors)
            turned = (arrangement.shift - then.shift) % count
            places = min(turned, count - turned)
            raise DonningError(Text("calibration-fit-turned", joint=names[joint], places=places, sensors=count))
