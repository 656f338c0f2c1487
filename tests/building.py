"""Makes small layouts, profiles, parameters and signals for tests, which fit together; none of these can be changed."""

import uuid
from functools import cache

import numpy as np

from app.calibration.linear_map import RATE_LAGS, LinearMap, MapCheck
from app.calibration.profile import CalibrationProfile, JointMap
from app.calibration.vocabulary import DriveParameters, standard_parameters
from app.layout import Channel, Joint, ShirtLayout
from app.process.ring import TickRing
from app.world.floorplan import FloorPlan

PAPER_JOINTS = ("right_elbow", "left_elbow", "right_shoulder", "left_shoulder")


AGREES = MapCheck(in_phase=0.95, hit_rate=0.7, false_per_minute=1.0, false_count=1)  # own repetitions with a map


@cache
def make_layout(n_channels=52, joints=PAPER_JOINTS):
    """Return a layout whose channels are assigned to the joints in turn."""
    return ShirtLayout(
        name="test shirt",
        channels=tuple(Channel(name=f"c{i}", joint=joints[i % len(joints)]) for i in range(n_channels)),
        joints=tuple(Joint(name=joint, label=joint.replace("_", " ")) for joint in joints),
    )


def covariance_of_independent(weights):
    """Return the covariance of channels that move independently, each by as much in what the weights (k,) read."""
    variances = 1.0 / np.square(weights)
    return tuple(map(tuple, np.diag(variances).tolist()))


def joint_map(name, channels, rates, weights=None, dead_zone=0.2, full=1.0, **changes):
    """Return a map that reads its channels with `rates`; `weights` are those of `covariance_of_independent`."""
    usual = {
        "mean": (0.0,) * len(channels),
        "evr": 0.9,
        "prompted": True,
        "rest_rate": 0.04,
        "step": 0.035,
        "filtered_step": 0.06,
        "covariance": covariance_of_independent([1.0] * len(channels) if weights is None else weights),
        "grade": "good",
        "reason": "Clear.",
    }
    pca = LinearMap(rates=(tuple(rates),), dead_zone=dead_zone, full=full)
    return JointMap(name=name, channels=tuple(channels), pca=pca, **{**usual, **changes})


def profile_of(layout, joints, low=0.0, high=1.0, sample_rate=100.0):
    """Return a profile of these maps, whose channels are within `low` and `high`."""
    count = len(layout.channels)
    return CalibrationProfile(
        created="2025-01-01T00:00:00+00:00",
        software="0",
        layout=layout,
        sample_rate=sample_rate,
        left_out={},
        low=(low,) * count,
        high=(high,) * count,
        noise=(0.0,) * count,
        joints=tuple(joints),
    )


@cache
def make_profile(n_channels=52, sample_rate=100.0, seed=1, joints=PAPER_JOINTS, dead_zone=0.2, full=1.0):
    """Return a profile with random unit weights and a range that no test signal leaves."""
    rng = np.random.default_rng(seed)
    layout = make_layout(n_channels, joints)
    maps = []
    for name, channels in layout.channels_of_joint.items():
        weights = rng.normal(size=len(channels))
        rates = tuple((weights / np.linalg.norm(weights) / 3.0).tolist())  # a span of 3
        mean = tuple(rng.normal(size=len(channels)).tolist())
        maps.append(joint_map(name, channels, rates, weights, dead_zone, full, mean=mean, rest_rate=0.02))
    return profile_of(layout, maps, -100.0, 100.0, sample_rate)


def taught_by_others(profile, repetitions=0, joints=None, **of_prior):
    """Return the profile with joints (all, or those named) that drive by other people and so many own repetitions."""
    maps = []
    for joint in profile.joints:
        if joints is not None and joint.name not in joints:
            maps.append(joint)
            continue
        part = (0.1,) * len(joint.channels)
        size = {"dead_zone": joint.pca.dead_zone, "full": joint.pca.full}
        own = {"people": 8, "repetitions": repetitions, **of_prior}
        prior = LinearMap(rates=(part,) * len(RATE_LAGS), short=part, long=part, **size, **own)
        maps.append(joint.model_copy(update={"map": "prior", "prior": prior, "prompted": repetitions > 0}))
    return profile.model_copy(update={"joints": tuple(maps)})


def with_gesture(parameters, index, **fields):
    """Return parameters of whose gestures one has other fields."""
    document = parameters.model_dump(mode="json")
    document["gestures"][index] |= fields
    return DriveParameters.model_validate(document)


def guided_map(rates, dead_zone=0.2, full=1.0, **changes):
    """Return a map that is learnt from three own repetitions, with both of its checks."""
    learnt = {"lag": 0.3, "repetitions": 3, "pca_check": AGREES, "check": AGREES}
    return LinearMap(rates=rates, dead_zone=dead_zone, full=full, **learnt | changes)


@cache
def make_parameters(**changes) -> DriveParameters:
    """Return the paper's vocabulary on `make_profile(**changes)`."""
    return standard_parameters(make_profile(**changes))


def make_signals(parameters, n=2000, seed=0, strokes=True):
    """Return values (n, n_channels) float32: joints that rest and make a stroke along their map, one after another."""
    rng = np.random.default_rng(seed)
    profile = parameters.profile
    values = rng.normal(scale=0.002, size=(n, len(profile.layout.channels)))
    rate = profile.sample_rate
    for turn, joint in enumerate(profile.joints):
        posture = np.zeros(n)
        start = int((1 + 1.5 * turn) * rate) + int(rng.integers(0, 0.5 * rate))
        while strokes and start < n:
            length = int(0.6 * rate)
            phase = np.clip((np.arange(n) - start) / length, 0, 1)
            back = np.clip((np.arange(n) - start - 2 * length) / (2 * length), 0, 1)
            posture += 0.6 * (phase**2 * (3 - 2 * phase) - back**2 * (3 - 2 * back))
            start += int(1.5 * len(profile.joints) * rate)
        channels = list(joint.channels)
        values[:, channels] += np.array(joint.mean) + np.outer(posture * joint.span, joint.direction)
    return values.astype(np.float32)


def plan_of(walls=(), **more):
    """Return a floor plan with one straight path, 6 m along x."""
    room = ((-2.0, -3.0), (9.0, -3.0), (9.0, 3.0), (-2.0, 3.0), (-2.0, -3.0))
    return FloorPlan.model_validate(
        {
            "name": "room",
            "title": "Room",
            "walls": [room, *walls],
            "paths": [{"name": "ahead", "title": "Ahead", "points": [(0.0, 0.0), (6.0, 0.0)], "instruction": "Go."}],
            **more,
        }
    )


def make_ring():
    """Return an empty ring that no other process can attach to, and whose memory goes with it."""
    ring = TickRing.create(f"bodydrive-test-{uuid.uuid4().hex}")
    ring.unlink()
    return ring
