"""Fits the map of each joint from other people, and from the person's own prompted movements where there are any.

Forecasts of each map stand beside it: how many movements will reach half of full (hits), and how often it acts at rest.
"""

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.clean_recording import CleanRecording
from app.calibration.dead_zone import LEAST_PRIOR_SHARE, LEAST_RANGE
from app.calibration.features import features
from app.calibration.gestures.cross_check import hit_level
from app.calibration.gestures.prediction import hit_probability
from app.calibration.guided.check import MARGIN, SHORTEST_REST, at_rest, check
from app.calibration.linear_map import KINDS, Arrangement, Forecast, LinearMap, MapCheck, map_parts
from app.calibration.map_grades import UNPROMPTED
from app.calibration.prior.arrangement import find_arrangement, ring_movement, sensors_at
from app.calibration.prior.documents import FEWEST_PEOPLE
from app.calibration.prior.frames import prompted_frames
from app.calibration.prior.hit_uncertainty import deviation_of_hits
from app.calibration.prior.map_prior import JointPrior, MapPrior, check_layout
from app.calibration.prior.moments import Moments
from app.calibration.prior.scale import channels_alive, first_movement, log_ranges, scales
from app.calibration.prior.solving import OwnFrames, solve, thresholds
from app.calibration.profile import CalibrationProfile, JointMap
from app.calibration.script import REPETITIONS
from app.layout import ShirtLayout
from app.texts import Text

DIRECTED = Text("grade-directed")
LARGEST_WEIGHT = 1e12  # FS per signal unit, as `app.quantities.Finite`
FREE_PERCENTILE = 97.0  # of the rate of free movement: its quick movements peak there
LEAST_FULL = 1.2  # of the dead-zone: a movement that hardly leaves it is not full at once
USUAL_FALSE, USUAL_MINUTES = 1.0, 0.5  # false activations expected before any is counted, and the rest they stand for

Array = NDArray[np.float64]


def _held_out_rate(frames: OwnFrames, people: Moments, sample_rate: float) -> Array:
    """Return the rate (n,) of each repetition by the map that is learnt without that repetition; Hz."""
    rate = np.empty(len(frames.label))
    for repetition in range(frames.repetitions):
        rows = frames.repetition == repetition
        others = frames.without(repetition)
        rate[rows] = frames.features[rows] @ solve(people, sample_rate, others if len(others.label) else None)
    return rate


def own_peaks(free: Array, dead_zone: float, held_out: Array | None, frames: OwnFrames | None) -> list[float]:
    """Return the peak rates of the person's movements, in the unit of the rates; empty when nothing is known of them.

    Those of the own repetitions; as long as these are fewer than a calibration has, the free movement counts as one.

    Parameters
    ----------
    free : (n,) array
        Rate during the free movement.
    dead_zone : float
        From where the rate counts: free movement that is slower was not this gesture.
    held_out : (m,) array or None
        Rate during the person's own repetitions, by maps that are learnt without them.
    frames : OwnFrames or None
        The labels of those repetitions.
    """
    peaks = []
    if held_out is not None and frames is not None:
        moving = [(frames.repetition == number) & (frames.label > 0) for number in range(frames.repetitions)]
        peaks = [float(held_out[rows].max()) for rows in moving if rows.any()]
    in_free = float(np.percentile(free, FREE_PERCENTILE)) if len(free) else 0.0
    return [*peaks, in_free] if len(peaks) < REPETITIONS and in_free > dead_zone else peaks


def own_full(peaks: Sequence[float], dead_zone: float, full: float) -> float:
    """Return the rate that is full for this person: the median peak, or `full` of other people where none is known."""
    return max(float(np.median(peaks)) if peaks else full, LEAST_FULL * dead_zone)


def expected_hits(peaks: Sequence[float], dead_zone: float, full: float, repetitions: int) -> Forecast | None:
    """Return the expected hits of 100 movements with so many own repetitions; None without any known peak."""
    if not peaks:
        return None
    share = hit_probability(peaks, hit_level(dead_zone, full))
    return Forecast(value=round(100 * share, 1), uncertainty=deviation_of_hits(repetitions))


def _expected_false(held_out: Array, frames: OwnFrames, dead_zone: float, sample_rate: float) -> Forecast | None:
    """Return the expected activations a minute at rest, from the pauses between the repetitions.

    None when the pauses are shorter than SHORTEST_REST; parameters as of `own_peaks`, `sample_rate` in Hz.
    """
    resting = at_rest(frames.label, round(MARGIN * sample_rate))
    seconds = float(resting.sum()) / sample_rate
    if seconds < SHORTEST_REST:
        return None
    active = (held_out > dead_zone) & resting
    count = int(np.count_nonzero(np.diff(active.astype(np.int8), prepend=0) > 0))
    minutes = seconds / 60.0 + USUAL_MINUTES
    return Forecast(
        value=round((count + USUAL_FALSE) / minutes, 2), uncertainty=round(math.sqrt(count + USUAL_FALSE) / minutes, 2)
    )


class PriorMapError(Exception):
    """A joint can have no map from other people; the reason says in one sentence why, and what to do."""

    def __init__(self, reason: Text) -> None:
        super().__init__(reason)
        self.reason = reason


class PriorFit(NamedTuple):
    """A profile with maps from other people where they could be made."""

    profile: CalibrationProfile
    reasons: dict[str, Text]  # joint without such a map -> why
    arrangement: dict[str, Arrangement]  # ring -> its detected arrangement


class _Arrangements(NamedTuple):
    """The arrangement that was detected for each ring, and the rings for which the clinician has overridden it."""

    detected: dict[str, Arrangement]
    overridden: frozenset[str]

    @property
    def used(self) -> dict[str, Arrangement]:
        """The arrangements by which a map reads the sensors: that of the layout where it was overridden."""
        return {
            ring: Arrangement() if ring in self.overridden else arrangement
            for ring, arrangement in self.detected.items()
        }

    @property
    def unused(self) -> dict[str, Arrangement]:
        """The detected arrangements that were overridden."""
        return {ring: arrangement for ring, arrangement in self.detected.items() if ring in self.overridden}


@dataclass(frozen=True, slots=True)
class _UsedChannels:
    """The person's channels that a joint's map reads, the channel of the prior for each, and their scales."""

    channels: tuple[int, ...]  # indices into a frame, of the channels that are used
    places: tuple[int, ...]  # indices into the prior's channels of this joint
    scale: Array  # (k,)
    dropped: tuple[int, ...]  # indices into a frame, of channels that move too little


def find_arrangements(prior: MapPrior, free: Array, sample_rate: float) -> dict[str, Arrangement]:
    """Return the arrangement of each ring that the prior has enough people for.

    It is detected in the first ten seconds of `free` (n, n_channels), which has no gaps. Empty for a shorter movement.
    """
    start = first_movement(free, sample_rate)
    if start is None:
        return {}
    return {
        ring: find_arrangement(ring_movement(start[:, sensors], sample_rate), prior.rings[ring])
        for ring, sensors in prior.layout.rings.items()
        if ring in prior.rings and prior.rings[ring].people >= FEWEST_PEOPLE
    }


def with_prior_maps(
    profile: CalibrationProfile,
    prior: MapPrior,
    recording: CleanRecording,
    as_worn: Collection[str] = (),
) -> PriorFit:
    """Return the profile with a map from other people beside the PCA map of each joint that the prior has.

    The map that decodes is not changed: a person chooses it. Where a joint was not prompted, the sign of its PCA map is
    made that of other people's movement.

    Parameters
    ----------
    profile : CalibrationProfile
        With PCA maps, fitted to the same recording.
    prior : MapPrior
        Of the same layout.
    recording : CleanRecording
        Of its free movement, ten seconds set the scale of the channels; its stretches are the own prompted movements.
    as_worn : collection of str
        Rings whose detected arrangement the clinician has overridden: the map reads them as in the layout.

    Raises
    ------
    PriorError
        When the prior is of another layout.
    """
    check_layout(prior.layout, profile.layout)
    arrangements = find_arrangements(prior, recording.free, recording.sample_rate)
    of_layout = {ring: sits for ring, sits in arrangements.items() if ring in profile.layout.rings}
    rings = _Arrangements(of_layout, frozenset(as_worn))
    joints, reasons = [], {}
    for joint in profile.joints:
        try:
            joints.append(_joint(joint, prior, recording, rings))
        except PriorMapError as error:
            joints.append(joint)
            reasons[joint.name] = error.reason
    return PriorFit(profile.model_copy(update={"joints": tuple(joints)}), reasons, of_layout)


def with_best_maps(profile: CalibrationProfile) -> CalibrationProfile:
    """Return the profile in which each joint is decoded by the map that its held-out repetitions favour.

    A joint that was never prompted is decoded by other people's map where there is one.
    """
    joints = tuple(joint.model_copy(update={"map": joint.best_map}) for joint in profile.joints)
    return profile.model_copy(update={"joints": joints})


def _joint(
    joint: JointMap,
    prior: MapPrior,
    recording: CleanRecording,
    rings: _Arrangements,
) -> JointMap:
    """Return the joint with its map from other people, or raise PriorMapError."""
    people = prior.joints.get(joint.name)
    if people is None or people.people < FEWEST_PEOPLE:
        count = 0 if people is None else people.people
        raise PriorMapError(Text("calibration-prior-few", count=count, needed=FEWEST_PEOPLE))
    rate, moved, layout = recording.sample_rate, recording.free, recording.layout
    used = _used_channels(joint, people, moved, rings.used, layout, rate)
    others = people.mean.of_channels(used.places)
    frames = prompted_frames(recording.stretches_of(joint.name), used.channels, used.scale, rate, others)
    weights = solve(others, rate, frames)
    dead_zone, full_of_others = thresholds(weights, others)
    if not full_of_others > 0.0:
        raise PriorMapError(Text("calibration-prior-unlike"))
    in_free = features(moved[:, list(used.channels)] / used.scale, rate)
    held_out = None if frames is None else _held_out_rate(frames, others, rate)
    peaks = own_peaks(in_free @ weights, dead_zone, held_out, frames)
    full = joint.pca.full
    in_fs = full / own_full(peaks, dead_zone, full_of_others)
    by_pca = _pca_weights(joint, used)
    if not joint.prompted and float((in_free @ weights) @ (in_free @ by_pca)) < 0.0:
        joint = joint.with_direction([-part for part in joint.direction])
    per_unit = _per_unit(weights * in_fs, used, joint)
    if np.abs(per_unit).max() > LARGEST_WEIGHT:
        raise PriorMapError(Text("calibration-prior-small"))
    lowest = max(dead_zone * in_fs, LEAST_PRIOR_SHARE * full)
    fitted = LinearMap(
        **map_parts(per_unit.tolist()),
        dead_zone=round(min(lowest, full - LEAST_RANGE), 4),
        full=full,
        people=people.people,
        repetitions=0 if frames is None else frames.repetitions,
        dropped=tuple(layout.channels[i].name for i in used.dropped),
        arrangement=_of_joint(rings.used, joint, layout),
        as_worn=_of_joint(rings.unused, joint, layout),
    )
    peaks = [peak * in_fs for peak in peaks]
    update: dict[str, object] = {"hits": expected_hits(peaks, fitted.dead_zone, fitted.full, fitted.repetitions)}
    if frames is not None and held_out is not None:
        held_out = held_out * in_fs
        pca = frames.features @ by_pca
        update |= {
            "false_per_minute": _expected_false(held_out, frames, fitted.dead_zone, rate),
            "check": _check(held_out, frames, fitted.dead_zone, fitted.full, rate),
            "pca_check": _check(pca, frames, joint.pca.dead_zone, full, rate),
        }
    fitted = fitted.model_copy(update=update)
    reason = tuple(DIRECTED if sentence == UNPROMPTED else sentence for sentence in joint.reason)
    return joint.model_copy(update={"prior": fitted, "reason": reason})


def _used_channels(
    joint: JointMap,
    people: JointPrior,
    moved: Array,
    arrangements: dict[str, Arrangement],
    layout: ShirtLayout,
    sample_rate: float,
) -> _UsedChannels:
    """Return which channels are used, for which of the prior's, and their scale; PriorMapError when none moves."""
    joint_channels = layout.channels_of_joint[joint.name]
    sensors = np.array(joint_channels)
    for ring, arrangement in arrangements.items():
        members = layout.rings[ring]
        if members[0] in joint_channels:
            sensors[[joint_channels.index(i) for i in members]] = np.array(members)[
                sensors_at(arrangement, len(members))
            ]
    used_by_others = people.alive > 0.0
    expected = np.where(used_by_others, people.expected, 0.0)
    usable = used_by_others & np.isin(sensors, joint.channels)
    start = first_movement(moved, sample_rate)
    logs = expected.copy()
    alive = usable.copy()
    if start is not None and usable.any():
        measured = log_ranges(start[:, sensors], sample_rate)
        logs[usable] = measured[usable]
        alive[usable] = channels_alive(measured[usable], expected[usable])
    if not alive.any():
        raise PriorMapError(Text("calibration-prior-still"))
    level = expected.copy()
    level[~used_by_others] = expected[used_by_others].mean()
    return _UsedChannels(
        tuple(sensors[alive].tolist()),
        tuple(np.flatnonzero(alive).tolist()),
        scales(logs, alive, level)[alive],
        tuple(sensors[usable & ~alive].tolist()),
    )


def _pca_weights(joint: JointMap, used: _UsedChannels) -> Array:
    """Return the weights (d,) with which the prior's features give the rate of the joint's PCA map, FS/s."""
    weights = np.zeros((KINDS, len(used.channels)))
    for column, (channel, scale) in enumerate(zip(used.channels, used.scale, strict=True)):
        weights[0, column] = joint.pca.rates[0][joint.channels.index(channel)] * scale
    return weights.ravel()


def _per_unit(weights: Array, used: _UsedChannels, joint: JointMap) -> Array:
    """Return the weights (KINDS, n) per signal unit, one column per channel of the joint's map."""
    columns = np.zeros((KINDS, len(joint.channels)))
    columns[:, [joint.channels.index(i) for i in used.channels]] = weights.reshape(KINDS, -1) / used.scale
    return columns


def _of_joint(arrangements: dict[str, Arrangement], joint: JointMap, layout: ShirtLayout) -> dict[str, Arrangement]:
    """Return the arrangements of a joint's rings that differ from the layout."""
    joint_channels = layout.channels_of_joint[joint.name]
    return {
        ring: arrangement
        for ring, arrangement in arrangements.items()
        if layout.rings[ring][0] in joint_channels and arrangement != Arrangement()
    }


def _check(rate: Array, frames: OwnFrames, dead_zone: float, full: float, sample_rate: float) -> MapCheck:
    return check(rate, frames.label, frames.repetition, dead_zone, full, sample_rate)
