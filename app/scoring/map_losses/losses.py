"""Whether the present map loses something over a person's trials: evidence for a change, from the person's own noise.

Five figures of each gesture are added up over the trials (CUSUM), each as its distance from what would be no loss, in
standard deviations of this person: noise at rest, size of the strokes (both ways), time missed, blindness of the
direction, and the time that S5 silenced. They are of the rate that the decoder gives, whatever kind of map the joint
has. There is a sentence only on figures with a loss. The figures of one trial are computed here, too.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.adaptation.change_limits import STANDARD_LIMITS
from app.calibration.adaptation.direction import principal, share_along
from app.calibration.adaptation.joint_loss import JointLoss
from app.calibration.adaptation.movement import (
    LONGEST_BREAK,
    SHORTEST_PIECE,
    SHORTEST_STROKE,
    Movement,
    gesture_of,
    rest_noise,
    stretches,
)
from app.calibration.adaptation.thresholds import dead_zone_for, least_dead_zone
from app.calibration.gaps import fill_forward
from app.calibration.profile import CalibrationProfile, JointMap
from app.calibration.vocabulary import DriveParameters, Gesture
from app.pipeline.channel_health import ChannelHealth
from app.pipeline.projection import projections
from app.pipeline.replay.batch import decode_block
from app.scoring.verdict.cusum import LIMIT, cumulative_sum, normal_score
from app.scoring.verdict.spread import CLINIC_WEIGHT, Series, Spread, Variance, own_spread, pool_spreads, weighted_sum
from app.texts import Figure, Text, in_sequence

FEWEST_STROKES = 3  # of a gesture in a trial
OWN_FACTOR = 2.0  # a stroke is a gesture's own where it is at least so many times as strong (rate / full) as any other
MOST_BAD = 0.2  # share of a trial; a gesture that read bad channels for longer has no figures of its movement

Numbers = NDArray[np.float64]
Flags = NDArray[np.bool_]


class GestureTrial(NamedTuple):
    """The figures of one gesture in one trial; None where the trial has too little rest or too few strokes."""

    noise: float | None  # ln of the rate's noise at rest (FS/s)
    size: float | None  # ln of the 90th percentile of its strokes' rates (FS/s)
    missed: float | None  # share of its strokes' time that the present dead-zone leaves unanswered
    blind: float | None  # share of the joint's rate that the direction of a PCA map does not see
    silent: float  # share of the trial in which safety rule S5 silenced it


def gesture_trials(parameters: DriveParameters, movement: Movement) -> dict[str, GestureTrial]:
    """Return the figures of each bound gesture that reads a rate, by its name, as `parameters` read the trial.

    A stroke is a stretch of the rate above the dead-zone that the noise of this trial needs, not above the present one:
    otherwise a dead-zone that is too large would hide what it costs.
    """
    bound = [i for i in parameters.bound_gestures if parameters.gestures[i].feature == "rate"]
    if not len(movement.values) or not bound:
        return {}
    values, sample_rate = np.asarray(movement.values, dtype=np.float32), movement.sample_rate
    uses = projections(parameters).uses
    health = ChannelHealth(parameters.profile, np.asarray(uses.any(axis=0)), sample_rate)
    bad = health.block(values.astype(np.float64), None)
    decoded = decode_block(parameters, sample_rate, np.arange(len(values)) / sample_rate, values)
    rates = decoded.rate
    strength = np.abs(rates) / np.array([gesture.full for gesture in parameters.gestures])
    filled = fill_forward(values.astype(np.float64))
    armed = np.asarray(movement.armed, dtype=np.bool_)
    joints = {joint.name: joint for joint in parameters.profile.joints}
    figures = {}
    for i in bound:
        gesture, joint = parameters.gestures[i], joints[parameters.gestures[i].joint]
        silent = float(decoded.silent[:, i].mean())
        is_unsure = decoded.silent[:, i] | (bad & uses[i]).any(axis=1)  # an estimate of a channel is no measurement
        if is_unsure.mean() > MOST_BAD:
            figures[gesture.name] = GestureTrial(None, None, None, None, silent)
            continue
        other_gestures = [other for other in bound if parameters.gestures[other].joint != joint.name]
        is_own = (
            armed & ~is_unsure & (strength[:, i] >= OWN_FACTOR * strength[:, other_gestures].max(axis=1, initial=0.0))
        )
        noise = rest_noise([rates[:, i]], [sample_rate])
        needed = least_dead_zone(joint) if noise is None else dead_zone_for(joint, noise)
        strokes = _strokes(rates[:, i], is_own, needed, sample_rate)
        figures[gesture.name] = GestureTrial(
            noise=math.log(noise) if noise else None,
            size=math.log(float(np.percentile(strokes, 90))) if strokes is not None else None,
            missed=float(np.mean(strokes <= gesture.dead_zone)) if strokes is not None else None,
            blind=_blindness(joint, filled, is_own & (np.abs(rates[:, i]) > needed), sample_rate),
            silent=silent,
        )
    return figures


def _strokes(rate: Numbers, is_own: Flags, above: float, sample_rate: float) -> Numbers | None:
    """Return the rates (FS/s) of all strokes above a rate, one after the other; None for fewer than three strokes."""
    strokes = [rate[piece] for piece in stretches(is_own & (rate > above), 0.0, SHORTEST_STROKE, sample_rate)]
    return np.concatenate(strokes) if len(strokes) >= FEWEST_STROKES else None


def _blindness(joint: JointMap, values: Numbers, moving: NDArray[np.bool_], sample_rate: float) -> float | None:
    """Return the share (0..1) of the movement's rate that is lost because the map points beside the movement.

    It is 1 - sqrt(share of the variance along the map / share along the movement's own main direction). A direction
    that is 8 degrees off loses 0.01, one of 18 degrees 0.05, one of 26 degrees 0.10.

    Parameters
    ----------
    joint
        With a PCA map; other maps have no direction to turn, and the answer is None.
    values
        (n, n_channels) signal units, without missing samples.
    moving
        (n,) where the joint makes a movement of its own.
    sample_rate
        Hz.
    """
    weights = np.array(joint.direction)
    if joint.map != "pca":
        return None
    signals = values[:, list(joint.channels)] * (weights != 0.0)
    pieces = stretches(moving, LONGEST_BREAK, SHORTEST_PIECE, sample_rate)
    rows = [signals[piece] - signals[piece].mean(axis=0) for piece in pieces]
    if sum(map(len, rows)) < STANDARD_LIMITS.least_movement * sample_rate:
        return None
    moved = np.concatenate(rows)
    covariance = moved.T @ moved
    main = principal(covariance, weights)
    if main is None or main.share <= 0.0:
        return None
    return max(0.0, 1.0 - math.sqrt(min(1.0, share_along(covariance, weights) / main.share)))


# Dead-zone over noise. A calibration begins with 4; at 3.5, a gesture at rest acts once in three minutes (Rice's
# formula with 2.5 upward crossings a second), at 3 nearly twice a minute.
LEAST_MARGIN = 3.5
MOST_MISSED = 0.10  # share of the strokes' time
LEAST_GROWTH = 0.10  # of the logarithm of the strokes' size: a smaller change is relearnt within a trial
MOST_BLIND = 0.05  # of the rate, more than in the first trials: a direction 18 degrees off costs as much
MOST_SILENT = 0.05  # share of a trial, as in the warning of a sensor: a drifting channel passes its range now and then
MOSTLY_SILENT = 0.20  # share of a trial: no drift, and no second trial is needed to be sure
FIRST_TRIALS = 5  # that later ones are compared with
LAST_TRIALS = 3  # of which the mean is what a changed full follows
MOST_TRIALS = 30  # the newest ones; older ones are not read again

# Standard deviations from trial to trial, until the person's own is known: of simulated people who stay as they are,
# whether the shirt stays on (noise 0.06, size 0.07) or is put on again (0.08, 0.08), rounded up.
USUAL = {"noise": 0.10, "size": 0.10, "missed": 0.05, "blind": 0.03, "silent": 0.05}


class PastTrial(NamedTuple):
    """One trial: its name among the others, how to read it, and the fulls it was driven with."""

    name: str
    movement: Callable[[], Movement | None]  # None when it is gone
    fulls: Mapping[str, float]  # gesture -> FS/s


class ReadTrials(NamedTuple):
    """The figures of trials as one set reads them."""

    hash: str  # of the set
    figures: Mapping[str, Mapping[str, GestureTrial]]  # name of the trial -> gesture -> figures


NOTHING_READ = ReadTrials("", {})


def read_trials(
    parameters: DriveParameters, trials: Sequence[PastTrial], known: ReadTrials = NOTHING_READ
) -> ReadTrials:
    """Return the figures of the newest trials as `parameters` read them; those that are `known` are not read again."""
    same = known.figures if known.hash == parameters.hash else {}
    figures = dict(same)
    for trial in trials[-MOST_TRIALS:]:
        if trial.name not in figures:
            movement = trial.movement()
            figures[trial.name] = {} if movement is None else gesture_trials(parameters, movement)
    return ReadTrials(parameters.hash, {trial.name: figures[trial.name] for trial in trials[-MOST_TRIALS:]})


def losses_of(
    parameters: DriveParameters, calibrated: CalibrationProfile, trials: Sequence[PastTrial], read: ReadTrials
) -> dict[str, JointLoss]:
    """Return what the present map of each joint loses; `trials` oldest first (see `joint_losses`)."""
    evidence = [TrialEvidence(read.figures[trial.name], trial.fulls) for trial in trials[-MOST_TRIALS:]]
    return joint_losses(parameters, calibrated, evidence)


class TrialEvidence(NamedTuple):
    """The figures of all gestures in one trial as the present set reads it, and with which fulls it was driven."""

    gestures: Mapping[str, GestureTrial]
    fulls: Mapping[str, float]  # gesture -> FS/s


def joint_losses(
    parameters: DriveParameters, calibrated: CalibrationProfile, trials: Sequence[TrialEvidence]
) -> dict[str, JointLoss]:
    """Return what the present map of each joint loses; joints that lose nothing are left out.

    Parameters
    ----------
    parameters
        The set that drives now.
    calibrated
        The calibration that it descends from.
    trials
        All trials with maps of this calibration, oldest first, those of earlier sessions too.
    """
    origins = {joint.name: joint for joint in calibrated.joints}
    losses = {}
    for joint in parameters.profile.joints:
        gesture = gesture_of(parameters, joint.name)
        if gesture is None:
            continue
        with_gesture = [trial for trial in trials if gesture.name in trial.gestures]
        figures = [trial.gestures[gesture.name] for trial in with_gesture]
        alike = [
            trial.gestures[gesture.name] for trial in with_gesture if trial.fulls.get(gesture.name) == gesture.full
        ]
        if figures:
            loss = _joint_loss(joint, origins.get(joint.name, joint), gesture, figures, alike)
            if loss is not None:
                losses[joint.name] = loss
    return losses


def _joint_loss(
    joint: JointMap, origin: JointMap, gesture: Gesture, trials: Sequence[GestureTrial], alike: Sequence[GestureTrial]
) -> JointLoss | None:
    """Return what one joint loses, None when that is nothing; `alike` are the trials with the present full."""
    sentences: list[Text] = []
    dead_zone, growth = _dead_zone(origin, gesture, trials, sentences), _growth(alike, sentences)
    turns = joint.map == "pca" and _is_blind(trials, sentences)
    silenced = _is_silenced(trials)
    if silenced:
        sentences.append(Text("calibration-loss-silent", percent=Figure(100 * trials[-1].silent)))
    return JointLoss(in_sequence(sentences), dead_zone, growth, turns, silenced) if sentences else None


def _dead_zone(
    origin: JointMap, gesture: Gesture, trials: Sequence[GestureTrial], sentences: list[Text]
) -> float | None:
    """Return the dead-zone (FS/s) that the noise asks for, None where the present one costs nothing."""
    noises = [trial.noise for trial in trials if trial.noise is not None]
    if not noises:
        return None
    needed = dead_zone_for(origin, math.exp(noises[-1]))
    target = math.log(gesture.dead_zone / LEAST_MARGIN)
    if needed > gesture.dead_zone and cumulative_sum(_surprises("noise", noises, target)) > LIMIT:
        sentences.append(Text("calibration-loss-noise"))
        return needed
    missed = [trial.missed for trial in trials if trial.missed is not None]
    if needed < gesture.dead_zone and cumulative_sum(_surprises("missed", missed, MOST_MISSED)) > LIMIT:
        sentences.append(Text("calibration-loss-missed", percent=Figure(100 * missed[-1])))
        return needed
    return None


def _growth(trials: Sequence[GestureTrial], sentences: list[Text]) -> float | None:
    """Return ln(size of the strokes now / in the first trials with this full), None where that is noise."""
    sizes = [trial.size for trial in trials if trial.size is not None]
    if len(sizes) <= FIRST_TRIALS:
        return None
    first = float(np.mean(sizes[:FIRST_TRIALS]))
    for sign, how in ((-1.0, "weaker"), (1.0, "stronger")):
        surprises = _surprises("size", [sign * size for size in sizes], sign * first + LEAST_GROWTH, FIRST_TRIALS)
        if cumulative_sum(surprises) > LIMIT:
            growth = float(np.mean(sizes[FIRST_TRIALS:][-LAST_TRIALS:])) - first
            sentences.append(Text(f"calibration-loss-{how}", percent=Figure(100 * abs(math.expm1(growth)))))
            return growth
    return None


def _is_blind(trials: Sequence[GestureTrial], sentences: list[Text]) -> bool:
    """Return whether the direction sees less of the movement than in the first trials with this calibration."""
    values = [trial.blind for trial in trials if trial.blind is not None]
    if len(values) <= FIRST_TRIALS:
        return False
    target = float(np.mean(values[:FIRST_TRIALS])) + MOST_BLIND
    if cumulative_sum(_surprises("blind", values, target, FIRST_TRIALS)) <= LIMIT:
        return False
    sentences.append(Text("calibration-loss-direction", percent=Figure(100 * values[-1])))
    return True


def _is_silenced(trials: Sequence[GestureTrial]) -> bool:
    """Return whether S5 silenced the gesture for much of the last trial, or for a part of it again and again."""
    shares = [trial.silent for trial in trials]
    if shares[-1] > MOSTLY_SILENT:
        return True
    return shares[-1] > MOST_SILENT and cumulative_sum(_surprises("silent", shares, MOST_SILENT)) > LIMIT


def _surprises(figure: str, values: Sequence[float], target: float, first: int = 0) -> list[float]:
    """Return how far each value lies above `target`, in standard deviations as known before it.

    `first`: how many values the target was computed from; they are not judged.
    """
    weight = 1.0 + (1.0 / first if first else 0.0)
    scores = [
        normal_score(values[i] - target, weighted_sum((weight, _spread(figure, values[:i]))))
        for i in range(first, len(values))
    ]
    return [score for score in scores if score is not None]


def _spread(figure: str, before: Sequence[float]) -> Variance:
    """Return the variance from trial to trial, drawn towards the usual one as far as little is known of the person.

    It is that of the differences of neighbouring trials over sqrt(2), around their mean: a trend does not count as
    noise, otherwise a slow change would hide itself (von Neumann, Annals of Mathematical Statistics 12, 1941).
    """
    steps = np.diff(np.asarray(before, dtype=np.float64)) / math.sqrt(2.0)
    place = np.arange(len(steps))
    usual = Spread(Variance(0.0, CLINIC_WEIGHT), Variance(USUAL[figure] ** 2, CLINIC_WEIGHT))
    return pool_spreads(own_spread(Series(place.astype(np.float64), place, steps)), usual).mean
