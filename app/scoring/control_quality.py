"""How well the map fitted the movements of one trial: per joint, and of the controls.

Pure functions on arrays. For a joint that a guided map decodes, the figures are those of its PCA map: they describe how
the person moves, not how the guided map decodes the movement.
"""

from collections.abc import Callable, Iterable

import numpy as np
from numpy.typing import NDArray

from app.calibration.gaps import fill_forward
from app.calibration.vocabulary import DriveParameters
from app.pipeline.channel_health import ChannelHealth
from app.pipeline.person_brakes import STOP_ACTIVATION
from app.quantities import Count, Document, Fraction, Name
from app.scoring.joint_quality import Amount, Degrees, JointQuality, joint_quality
from app.scoring.stops_and_pulses import onsets
from app.texts import Text

MOST_BAD = 0.1  # share of the time; a channel that was bad for longer is left out of its joint's figures
SILENT_SHARE = 0.5  # of a bad channel's frames; with more of them constant or missing, the channel is called silent
LEAST_DISTANCE = 0.5  # m; activations per metre are not computed for less

Numbers = NDArray[np.float64]
Flags = NDArray[np.bool_]


class BadChannel(Document):
    """A channel that was bad for some of the time: its share of the time, and whether it gave a signal."""

    name: Name
    joint: Name
    share: Fraction  # of the time for which motion was permitted
    silent: bool  # mostly constant or not finite while it was bad; otherwise outside its calibrated range


class ControlQuality(Document):
    """The control quality of a trial; figures of joints are those of the worst joint, None where none moved enough."""

    map_angle_deg: Degrees | None
    evr: Fraction | None
    null_space_share: Fraction | None
    cross_talk: Fraction | None  # share of all activation that is not the strongest gesture's; None without any
    activations: Count
    activations_per_metre: Amount | None
    joints: tuple[JointQuality, ...]
    bad_channels: tuple[BadChannel, ...]  # of those that the map uses


def control_quality(
    parameters: DriveParameters,
    sample_rate: float,
    values: NDArray[np.floating],
    armed: Flags,
    activation: Numbers,
    distance: float,
) -> ControlQuality:
    """Return how well the map fitted the movements of one trial.

    Parameters
    ----------
    parameters
        The parameters of the trial.
    sample_rate
        Hz.
    values
        (n, n_channels) signal units: all frames of the recording, NaN where a sample is missing.
    armed
        (n,) where motion was permitted; all figures are of these frames.
    activation
        (n, n_gestures) as decoded in the trial.
    distance
        Distance driven, m.

    Raises
    ------
    ValueError
        When the arrays do not fit the parameters, or motion was never permitted.
    """
    profile = parameters.profile
    if values.shape != (len(armed), len(profile.layout.channels)) or not armed.any():
        raise ValueError(Text("measure-quality-no-frames"))
    if activation.shape != (len(armed), len(parameters.gestures)):
        raise ValueError(Text("measure-quality-gestures"))
    bound = parameters.bound_gestures
    counts = [onsets(activation[armed, gesture]) for gesture in bound]
    bound_gestures = [parameters.gestures[gesture] for gesture in bound]
    joint_of = [gesture.joint for gesture in bound_gestures]
    joints = [joint for joint in profile.joints if joint.name in joint_of]
    signals = np.asarray(values, dtype=np.float64)
    used = np.zeros(signals.shape[1], dtype=np.bool_)
    used[[channel for joint in joints for channel in joint.channels]] = True
    bad = ChannelHealth(profile, used, sample_rate).block(signals, None)
    bad_share = bad[armed].mean(axis=0)
    filled = fill_forward(np.where(np.isfinite(signals), signals, np.nan))
    qualities = []
    for joint in joints:
        good = [channel for channel in joint.channels if bad_share[channel] <= MOST_BAD]
        usable = armed & ~bad[:, good].any(axis=1)
        activations = sum(count for count, name in zip(counts, joint_of, strict=True) if name == joint.name)
        dead_zones = [
            gesture.dead_zone for gesture in bound_gestures if gesture.joint == joint.name and gesture.feature == "rate"
        ]
        dead_zone = min(dead_zones, default=None)
        qualities.append(
            joint_quality(joint, good, profile.layout, filled, usable, sample_rate, activations, dead_zone)
        )
    return ControlQuality(
        map_angle_deg=_worst(max, (quality.map_angle_deg for quality in qualities)),
        evr=_worst(min, (quality.evr for quality in qualities)),
        null_space_share=_worst(max, (quality.null_space_share for quality in qualities)),
        cross_talk=cross_talk(activation[armed][:, bound], _stops(parameters, bound)),
        activations=sum(counts),
        activations_per_metre=sum(counts) / distance if distance >= LEAST_DISTANCE else None,
        joints=tuple(qualities),
        bad_channels=tuple(
            BadChannel(
                name=profile.layout.channels[index].name,
                joint=profile.layout.channels[index].joint,
                share=float(bad_share[index]),
                silent=_silent(signals[:, index], armed & bad[:, index]),
            )
            for index in np.flatnonzero(bad_share).tolist()
        ),
    )


def cross_talk(activation: Numbers, stops: Iterable[list[int]] = ()) -> float | None:
    """Return the share of all activation that is not the strongest gesture's of its frame; None without activation.

    0 when only one gesture is active at a time; at most (k - 1) / k, when all k are equally active. Two gestures made
    together on purpose, such as a turn while speeding up, count as cross-talk; those of a stop, which asks for several
    gestures together, do not.

    Parameters
    ----------
    activation
        (n, k) of the bound gestures, 0..1.
    stops
        For each stop, the columns of the gestures that it asks for together.
    """
    deliberate = np.zeros(len(activation), dtype=np.bool_)
    for stop in stops:
        deliberate |= (activation[:, stop] >= STOP_ACTIVATION).all(axis=1)
    counted = activation[~deliberate]
    total = float(counted.sum())
    if total <= 0:
        return None
    return min(1.0, max(0.0, 1.0 - float(counted.max(axis=1).sum()) / total))


def _silent(signal: Numbers, where: Flags) -> bool:
    """Return whether a channel (n,) was constant or not finite in more than half of the frames `where` (n,)."""
    still = ~np.isfinite(signal)
    still[1:] |= signal[1:] == signal[:-1]
    return bool(still[where].mean() > SILENT_SHARE)


def _stops(parameters: DriveParameters, bound: list[int]) -> list[list[int]]:
    """Return, for each stop of several gestures, their columns among the bound gestures."""
    names = [parameters.gestures[gesture].name for gesture in bound]
    return [
        [names.index(name) for name in binding.gestures]
        for binding in parameters.bindings
        if binding.control == "stop" and len(binding.gestures) > 1
    ]


def _worst(choose: Callable[[list[float]], float], values: Iterable[float | None]) -> float | None:
    numbers = [value for value in values if value is not None]
    return choose(numbers) if numbers else None
