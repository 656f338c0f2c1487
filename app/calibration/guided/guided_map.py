"""Fits the guided map of each joint: ridge regression to the prompts, checked on held-out repetitions."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.clean_recording import CleanRecording
from app.calibration.dead_zone import LARGEST_GUIDED_SHARE, dead_zone_over, full_over
from app.calibration.features import features
from app.calibration.fit.repetitions import Stretch
from app.calibration.guided.check import SHORTEST_REST, check, dead_zone_of
from app.calibration.guided.labels import CuedMovement, labels, lags_of
from app.calibration.linear_map import KINDS, RATE_LAGS, LinearMap, MapCheck, map_parts
from app.calibration.profile import CalibrationProfile, JointMap
from app.calibration.ridge import ridge
from app.texts import Text

LARGEST_WEIGHT = 1e12  # FS per signal unit, as `app.quantities.Finite`
FEWEST = 3  # repetitions: one is held out, and two are fitted to
SHORTEST_CUE = 0.25  # s: a shorter cue covers a part of a movement only
ALIGNMENTS = 3  # iterations of fitting the map and estimating the lags with it
DELAY = 0.075  # s: delay of the low-pass at 3 Hz
LEAD = 0.05  # s by which the labels are shifted ahead, so that the map makes up for a part of the delay
RIDGE = 0.03  # ridge on the rates, relative to each channel's variance
LEVEL_RIDGES = (np.inf, 30.0, 10.0, 3.0, 1.0, 0.3)  # ridges on the levels to choose from; inf leaves the levels out
LEVELS_MUST_GAIN = 0.02  # in-phase share that a smaller ridge must gain: levels contain drift

Array = NDArray[np.float64]


class GuidedMapError(Exception):
    """A joint can have no guided map; the reason says in one sentence why, and what to do."""

    def __init__(self, reason: Text) -> None:
        super().__init__(reason)
        self.reason = reason


class GuidedFit(NamedTuple):
    """A profile with guided maps where one could be fitted."""

    profile: CalibrationProfile
    reasons: dict[str, Text]  # joint without a guided map -> why


@dataclass(frozen=True, slots=True)
class _Piece:
    """One stretch of one joint, with the features to fit to."""

    features: Array  # (n, KINDS k)
    pca: Array  # (n,) rate of the PCA map, FS/s
    cued: tuple[CuedMovement, ...]


@dataclass(frozen=True, slots=True)
class _TrainingRows:
    """All frames of one joint with their labels, one row per frame."""

    features: Array  # (n, KINDS k)
    pca: Array  # (n,) FS/s
    label: NDArray[np.int8]  # (n,) +1 in the prompted movement, -1 on the way back, 0 elsewhere
    repetition: NDArray[np.int_]  # (n,) number of the repetition; -1: the recording at rest


def with_guided_maps(profile: CalibrationProfile, recording: CleanRecording) -> GuidedFit:
    """Return the profile with a guided map beside the PCA map of each joint that has enough prompted repetitions.

    The map that decodes is not changed: a person chooses it.

    Parameters
    ----------
    profile : CalibrationProfile
        With PCA maps, fitted to the same recording.
    recording : CleanRecording
        Its stretches and its rest are read.
    """
    joints, reasons = [], {}
    for joint in profile.joints:
        stretches = recording.stretches_of(joint.name)
        try:
            guided = _guided_map(joint, stretches, recording.rest, recording.sample_rate)
            joints.append(joint.model_copy(update={"guided": guided}))
        except GuidedMapError as error:
            joints.append(joint)
            reasons[joint.name] = error.reason
    return GuidedFit(profile.model_copy(update={"joints": tuple(joints)}), reasons)


def _guided_map(joint: JointMap, stretches: Sequence[Stretch], rest: Array | None, sample_rate: float) -> LinearMap:
    """Return the guided map of one joint, or raise GuidedMapError."""
    pieces = [_piece(joint, stretch, sample_rate) for stretch in stretches]
    count = sum(len(piece.cued) for piece in pieces)
    if not joint.prompted or count == 0:
        raise GuidedMapError(Text("calibration-guided-unprompted", least=FEWEST))
    if count < FEWEST:
        raise GuidedMapError(Text("calibration-guided-few", count=count, least=FEWEST))
    pieces = [piece for piece in pieces if piece.cued]
    lags = [lags_of(piece.pca, piece.cued, sample_rate) for piece in pieces]
    for _ in range(ALIGNMENTS):
        data = _training_rows(joint, pieces, lags, rest, sample_rate)
        weights = _Regression(data).weights(np.inf)
        lags = [lags_of(piece.features @ weights, piece.cued, sample_rate) for piece in pieces]
    data = _training_rows(
        joint,
        pieces,
        [[lag - round(LEAD * sample_rate) for lag in piece_lags] for piece_lags in lags],
        rest,
        sample_rate,
    )
    if (data.label == 0).sum() < SHORTEST_REST * sample_rate:
        raise GuidedMapError(Text("calibration-guided-no-rest", seconds=SHORTEST_REST))
    pca_check = check(data.pca, data.label, data.repetition, joint.pca.dead_zone, joint.pca.full, sample_rate)
    regression = _Regression(data)
    candidates = [_candidate(data, regression, level, joint, pca_check, sample_rate) for level in LEVEL_RIDGES]
    best = max(candidate.check.in_phase for candidate in candidates)
    chosen = next(candidate for candidate in candidates if candidate.check.in_phase >= best - LEVELS_MUST_GAIN)
    weights = chosen.weights
    if np.abs(weights).max() > LARGEST_WEIGHT:
        raise GuidedMapError(Text("calibration-guided-small"))
    return LinearMap(
        **map_parts(weights.reshape(KINDS, -1).tolist()),
        dead_zone=chosen.dead_zone,
        full=chosen.full,
        lag=float(np.median(np.concatenate(lags))) / sample_rate - DELAY,
        repetitions=count,
        pca_check=pca_check,
        check=chosen.check,
    )


def _piece(joint: JointMap, stretch: Stretch, sample_rate: float) -> _Piece:
    readings = features(stretch.values[:, list(joint.channels)], sample_rate)
    return _Piece(
        features=readings,
        pca=readings[:, : len(joint.channels)] @ np.array(joint.pca.rates[0]),
        cued=tuple(
            CuedMovement(movement.start, movement.stop)
            for movement in stretch.moving
            if movement.stop - movement.start >= SHORTEST_CUE * sample_rate
        ),
    )


def _training_rows(
    joint: JointMap, pieces: Sequence[_Piece], lags: Sequence[Sequence[int]], rest: Array | None, sample_rate: float
) -> _TrainingRows:
    """Return all rows with their labels; the rest around a repetition gets that repetition's number."""
    label, repetition, before = [], [], 0
    for piece, piece_lags in zip(pieces, lags, strict=True):
        label.append(labels(piece.pca, piece.cued, piece_lags, sample_rate))
        starts = [movement.start + lag for movement, lag in zip(piece.cued, piece_lags, strict=True)]
        edges = [_middle_of_pause(label[-1], start, following) for start, following in pairwise(starts)]
        repetition.append(before + np.searchsorted(np.array(edges, dtype=np.int_), np.arange(len(piece.pca)), "right"))
        before += len(piece.cued)
    parts = [piece.features for piece in pieces]
    pca = [piece.pca for piece in pieces]
    if rest is not None:
        still = _piece(joint, Stretch(joint.name, rest, ()), sample_rate)
        parts.append(still.features)
        pca.append(still.pca)
        label.append(np.zeros(len(rest), dtype=np.int8))
        repetition.append(np.full(len(rest), -1))
    return _TrainingRows(np.concatenate(parts), np.concatenate(pca), np.concatenate(label), np.concatenate(repetition))


def _middle_of_pause(label: NDArray[np.int8], start: int, following: int) -> int:
    """Return the row half-way between the end of one repetition's way back and the beginning of the next movement."""
    busy = np.flatnonzero(label[max(start, 0) : max(following, 0)])
    end = max(start, 0) + (int(busy[-1]) + 1 if len(busy) else 0)
    return (end + max(following, end)) // 2


class _Regression:
    """Ridge regression to the labels; keeps the sums of each repetition, so that leaving one out costs no new pass."""

    def __init__(self, data: _TrainingRows) -> None:
        self._variance = data.features.var(axis=0)
        names = np.unique(data.repetition).tolist()
        rows = {name: data.repetition == name for name in names}
        self._count = {name: int(mask.sum()) for name, mask in rows.items()}
        self._gram = {name: data.features[mask].T @ data.features[mask] for name, mask in rows.items()}
        self._moment = {name: data.features[mask].T @ data.label[mask] for name, mask in rows.items()}

    def weights(self, level_ridge: float, without: int | None = None) -> Array:
        """Return the weights (KINDS k,) fitted to all repetitions, or to all but one; earlier rates are not read."""
        names = [name for name in self._gram if name != without]
        gram = np.sum([self._gram[name] for name in names], axis=0)
        moment = np.sum([self._moment[name] for name in names], axis=0)
        kinds = [RIDGE, *[np.inf] * (len(RATE_LAGS) - 1), level_ridge, level_ridge]
        strength = np.repeat(kinds, len(moment) // KINDS)
        read = (self._variance > 0.0) & np.isfinite(strength)
        penalty = np.full(len(moment), np.inf)
        penalty[read] = sum(self._count[name] for name in names) * strength[read] * self._variance[read]
        return ridge(gram, moment, penalty)


class _Candidate(NamedTuple):
    weights: Array
    dead_zone: float
    full: float
    check: MapCheck


def _candidate(
    data: _TrainingRows, regression: _Regression, level_ridge: float, joint: JointMap, pca: MapCheck, sample_rate: float
) -> _Candidate:
    """Return the map for one ridge on the levels, with its thresholds and its check on held-out repetitions."""
    weights = regression.weights(level_ridge)
    held_out = data.features @ weights
    for name in np.unique(data.repetition[data.repetition >= 0]):
        rows = data.repetition == name
        held_out[rows] = data.features[rows] @ regression.weights(level_ridge, without=int(name))
    moving = held_out[data.label > 0]
    strong = float(np.percentile(moving, 90))
    if strong <= 0.0:
        raise GuidedMapError(Text("calibration-guided-unlike"))
    scale = joint.pca.full / strong
    held_out = held_out * scale
    resting = held_out[data.repetition < 0]
    noise = float(resting.std()) if len(resting) else 0.0
    same_hits = min(dead_zone_of(held_out, data.label, pca.hit_rate), LARGEST_GUIDED_SHARE * joint.pca.full)
    dead_zone = dead_zone_over(noise, same_hits)
    full = full_over(dead_zone, joint.pca.full)
    return _Candidate(
        weights=weights * scale,
        dead_zone=dead_zone,
        full=full,
        check=check(held_out, data.label, data.repetition, dead_zone, full, sample_rate),
    )
