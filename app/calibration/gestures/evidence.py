"""Rates of all joints during each phase of a calibration, computed with the profile's map."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from app.calibration.cued_runs import CuedRun, Phase
from app.calibration.features import features
from app.calibration.fit.joint_evidence import LAG, SETTLING
from app.calibration.gaps import Frames
from app.calibration.profile import CalibrationProfile, JointMap
from app.signals.low_pass import STANDARD_CUTOFF, smooth

WAITING = 0.5  # s before a prompt, in which a person waits at rest


@dataclass(frozen=True, slots=True)
class RepetitionRates:
    """The rates (n, n_joints) in FS/s of one repetition: on the way there, on the way back, and of both."""

    joint: str
    there: Frames
    back: Frames
    whole: Frames
    travel_there: float  # FS
    travel_back: float  # FS


@dataclass(frozen=True, slots=True)
class Evidence:
    """The rates (n, n_joints) in FS/s of all recordings, one column per joint of the profile."""

    sample_rate: float
    rest: list[Frames] = field(default_factory=list)  # the step at rest
    pauses: list[tuple[str | None, Frames]] = field(default_factory=list)  # joint that moved before, rates
    free: list[Frames] = field(default_factory=list)
    repetitions: list[RepetitionRates] = field(default_factory=list)

    def at_rest(self, column: int) -> list[NDArray[np.float64]]:
        """Return one joint's rates in the step at rest."""
        return [piece[:, column] for piece in self.rest]

    def noise_of(self, joint: JointMap, column: int) -> float:
        """Return the noise (FS/s) of a joint's rate at rest: the profile's for a PCA map, measured for another."""
        pieces = self.at_rest(column)
        if joint.map == "pca" or not pieces:
            return joint.rest_rate
        return float(np.concatenate(pieces).std())

    def in_pauses(self, column: int, joint: str) -> list[NDArray[np.float64]]:
        """Return one joint's rates between the prompts, except after its own movements, when it may still move back."""
        return [piece[:, column] for after, piece in self.pauses if after != joint]


def gather_evidence(profile: CalibrationProfile, runs: Sequence[CuedRun]) -> Evidence:
    """Return the rates of the profile's joints in the recordings, filtered by the chain's low-pass."""
    rate_of = profile.sample_rate
    evidence = Evidence(rate_of)
    for run in runs:
        places = smooth(_scores(profile, run.values), STANDARD_CUTOFF, rate_of)
        rates = np.diff(places, axis=0, prepend=places[:1]) * rate_of
        for column, joint in enumerate(profile.joints):
            if joint.map != "pca":
                readings = features(run.values[:, list(joint.channels)], rate_of)
                rates[:, column] = readings @ np.concatenate(joint.linear.parts)
        for index, phase in enumerate(run.phases):
            _add_phase(evidence, profile, run.phases, index, phase, places, rates)
    return evidence


def _scores(profile: CalibrationProfile, values: Frames) -> Frames:
    weights = np.zeros((values.shape[1], len(profile.joints)))
    offsets = np.zeros(len(profile.joints))
    for column, joint in enumerate(profile.joints):
        channels = list(joint.channels)
        weights[channels, column] = joint.pca.rates[0]
        offsets[column] = weights[channels, column] @ np.array(joint.mean)
    return values @ weights - offsets


def _add_phase(
    evidence: Evidence,
    profile: CalibrationProfile,
    phases: Sequence[Phase],
    index: int,
    phase: Phase,
    places: Frames,
    rates: Frames,
) -> None:
    """Append the rates of one phase to the list of its kind."""
    rows, late = phase.rows, round(LAG * evidence.sample_rate)
    match phase.kind:
        case "rest" if phase.joint is None:
            evidence.rest.append(rates[rows.start + round(SETTLING * evidence.sample_rate) : rows.stop])
        case "rest":
            evidence.pauses.append((phase.joint, rates[rows.start + late : rows.stop]))
        case "ready" if phase.joint is not None:
            start = max(rows.start + late, rows.stop - round(WAITING * evidence.sample_rate))
            evidence.pauses.append((None, rates[start : rows.stop]))
        case "free":
            evidence.free.append(rates[rows])
        case "move" if phase.joint is not None:
            back = phases[index + 1].rows if _is_way_back(phases, index) else slice(rows.stop, rows.stop)
            evidence.repetitions.append(_repetition_rates(profile, phase.joint, rows, back, late, places, rates))


def _is_way_back(phases: Sequence[Phase], index: int) -> bool:
    following = phases[index + 1 : index + 2]
    return bool(following) and following[0].kind == "return" and following[0].joint == phases[index].joint


def _repetition_rates(
    profile: CalibrationProfile, joint: str, rows: slice, back: slice, late: int, places: Frames, rates: Frames
) -> RepetitionRates:
    """Return the rates of one repetition, with LAG, or half of the prompt if that is less, added at its end."""
    last = min(len(rates), rows.stop + min(late, (rows.stop - rows.start + 1) // 2))
    end = last if back.stop == back.start else min(len(rates), back.stop + late)
    there, way_back = slice(rows.start, last), slice(back.start, end)
    columns = [
        index for index, joint_map in enumerate(profile.joints) if joint_map.name == joint
    ]  # none when it has no map
    return RepetitionRates(
        joint,
        rates[there],
        rates[way_back],
        rates[rows.start : end],
        _travel(places[there, columns]),
        _travel(places[way_back, columns]),
    )


def _travel(place: Frames) -> float:
    return float(np.ptp(place)) if place.size else 0.0
