"""Signals that no movement makes, added to those of a person at rest: how far the chair goes, by mode and kind of map.

`python -m bench.artefacts` prints the figures of docs/safety.md.
"""

import itertools
import math
import sys
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple, get_args

import numpy as np
from numpy.typing import NDArray

from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import ControlMode, DriveParameters, Feature, standard_parameters
from app.faults import Fault, State
from app.hardware.base import ORIGIN
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.person_parameters import PRACTISED
from app.hardware.chair.simulator import VirtualChair
from app.hardware.shirt.standard import standard_layout
from app.messages import SensorFrame
from app.pipeline.chain import Chain
from app.pipeline.safety_gate import Conditions
from app.study.choices import StudyMap
from app.study.participant import Participant
from app.study.sessions import calibrated_participant
from app.study.simulated_calibration import calibrate

Array = NDArray[np.float64]
Course = Callable[[Array, np.random.Generator], Array]
"""From times (n,) in s to what is added, in half ranges of each channel; 0 at the beginning."""

CALM = 2.5  # s at rest before the artefact begins
ARMED_LATE = 2.5  # s of the artefact before the chair is armed, where it is armed while it lasts
LASTS = 36.0  # s
HUM = 0.3  # half ranges
DISPLACEMENT = {"feature": "displacement", "dead_zone": 0.15, "full": 0.6}  # FS


@dataclass(frozen=True, slots=True)
class Artefact:
    """What is added to the channels of all joints, or of the one that drives forward."""

    words: str  # KIND: DETAILS
    course: Course
    all_joints: bool = False
    along: bool = True
    """Whether each channel changes towards the movement, which is the worst case; otherwise all change alike."""


class Subject(NamedTuple):
    """A calibrated person at rest."""

    words: str
    parameters: DriveParameters
    sample_rate: float  # Hz
    rest: NDArray[np.float32]  # (n, n_channels)


class Outcome(NamedTuple):
    """What the chair did."""

    speed: float  # m/s, largest
    way: float  # m, length of the way
    fault: Fault
    armed: bool  # whether it was armed at any time after the artefact began


def _numbers(values: NDArray[np.floating]) -> Array:
    return np.asarray(values, dtype=np.float64)


def square(size: float, frequency: float) -> Course:
    """Return a connector that opens and closes evenly, `frequency` times a second."""
    return lambda t, _: _numbers(size * (np.floor(2.0 * frequency * t) % 2.0))


def telegraph(size: float, changes: float) -> Course:
    """Return a connector that opens and closes at random, `changes` times a second on average."""
    return lambda t, random: _numbers(size * (np.cumsum(random.random(len(t)) < changes * np.diff(t, prepend=0.0)) % 2))


def spikes(size: float, frequency: float) -> Course:
    """Return jumps that last one frame."""
    return lambda t, _: _numbers(size * (np.diff(np.floor(frequency * t), prepend=0.0) > 0.0))


def passed(course: Course, seconds: float) -> Course:
    """Return a course as it leaves a low-pass filter of first order with a time constant of `seconds`."""

    def behind_filter(t: Array, random: np.random.Generator) -> Array:
        from scipy.signal import lfilter

        share = -math.expm1(-(t[1] - t[0]) / seconds)
        return _numbers(lfilter([share], [1.0, share - 1.0], course(t, random)))

    return behind_filter


def sine(size: float, frequency: float) -> Course:
    """Return breathing, swaying, or the hum of a mains."""
    return lambda t, _: _numbers(size * np.sin(2.0 * np.pi * frequency * t))


ARTEFACTS = (
    *(
        Artefact(f"connector: {size:g}, {frequency:g} Hz", square(size, frequency))
        for size, frequency in itertools.product((0.3, 0.15, 0.08), (0.5, 1.0, 2.0))
    ),
    Artefact("connector at random: 0.3", telegraph(0.3, 1.0)),
    Artefact("connector at random: 0.15", telegraph(0.15, 1.0)),
    *(
        Artefact(f"{words}, {1e3 * seconds:g} ms", passed(course, seconds))
        for seconds in (0.01, 0.02, 0.05)
        for words, course in (
            ("connector behind a filter: 0.3, 0.5 Hz", square(0.3, 0.5)),
            ("connector behind a filter: 0.15, 1 Hz", square(0.15, 1.0)),
            ("connector at random behind a filter: 0.3", telegraph(0.3, 1.0)),
        )
    ),
    Artefact("spikes of one frame: 0.2, one a second", spikes(0.2, 1.0)),
    *(
        Artefact(f"{words}: {size:g}, {frequency:g} Hz", sine(size, frequency), all_joints=True, along=along)
        for along, words in ((False, "all channels sway alike"), (True, "all joints sway towards their movements"))
        for size, frequency in ((0.2, 0.5), (0.2, 1.0), (0.2, 2.0), (0.1, 1.0), (0.3, 0.3))
    ),
)
ONE_JOINT_SWAYS = tuple(
    Artefact(f"one joint sways towards its movement: {size:g}, {frequency:g} Hz", sine(size, frequency))
    for size, frequency in ((0.1, 1.0), (0.2, 0.5), (0.2, 1.0), (0.2, 2.0), (0.4, 0.3))
)
"""Each of these begins as a stroke does: only its repetition is no movement."""


def hums(sample_rate: float) -> tuple[Artefact, ...]:
    """Return the hum of mains of 50 and 60 Hz, and of a mains 0.4 Hz beside the sampling rate."""
    mains = sorted({50.0, 60.0, sample_rate + 0.4})
    return tuple(
        Artefact(
            f"hum {'towards the movements' if along else 'alike'}: {one:g} Hz at {sample_rate:g} Hz",
            sine(HUM, one),
            all_joints=True,
            along=along,
        )
        for one, along in itertools.product(mains, (False, True))
    )


def subject(kind: StudyMap, sample_rate: float = 100.0, seed: int = 6) -> Subject:
    """Return a simulated person with a map of one kind, and the frames of the rest after the calibration."""
    if kind == "pca":
        participant = Participant(SimulatedPerson(PRACTISED, seed), standard_layout(), sample_rate, seed)
        profile = calibrate(participant)
    else:
        calibrated = calibrated_participant("steady", seed, kind)
        participant, profile, sample_rate = (
            calibrated.participant,
            calibrated.profile,
            calibrated.participant.sample_rate,
        )
    frames = [participant.rest().values for _ in range(round((CALM + LASTS + 5.0) * sample_rate))]
    return Subject(kind, standard_parameters(profile), sample_rate, np.stack(frames)[round(4.0 * sample_rate) :])


def in_mode(one: Subject, mode: ControlMode, feature: Feature) -> Subject:
    """Return the subject with both axes in a mode, driven by rates or by displacements."""
    gestures = one.parameters.gestures
    if feature == "displacement":
        gestures = tuple(gesture.model_copy(update=DISPLACEMENT) for gesture in gestures)
    changes = {"mode_u1": mode, "mode_u2": mode, "gestures": gestures}
    return one._replace(parameters=one.parameters.model_copy(update=changes))


def outcome(one: Subject, artefact: Artefact, *, armed_before: bool = True) -> Outcome:
    """Return what a chair does that is armed before the artefact begins, or while it lasts."""
    chain = Chain(one.sample_rate, one.parameters, VirtualChair(None, ORIGIN))
    calm = round(CALM * one.sample_rate)
    arm_at = 0 if armed_before else calm + round(ARMED_LATE * one.sample_rate)
    added = _added(one.parameters.profile, one.sample_rate, artefact)
    frames = one.rest[: calm + len(added)].copy()
    frames[calm:] += added[: len(frames) - calm].astype(np.float32)
    conditions = Conditions()
    way = speed = 0.0
    was_armed = False
    for i, values in enumerate(frames):
        if i == arm_at:
            chain.arm()
        t = i / one.sample_rate
        tick = chain.step(SensorFrame(i, t, t, values), t, conditions)
        if i == calm and armed_before and tick.state is not State.ARMED:
            raise RuntimeError("the chair was not armed at rest")
        way += abs(tick.v) / one.sample_rate
        speed = max(speed, abs(tick.v))
        was_armed |= i > calm and tick.state is State.ARMED
        if tick.state is State.FAULT and tick.v == tick.omega == 0.0:
            break
    return Outcome(speed, way, chain.gate.fault, was_armed)


def _added(profile: CalibrationProfile, sample_rate: float, artefact: Artefact) -> Array:
    """Return what the artefact adds to each frame (n, n_channels), signal units."""
    t = np.arange(round(LASTS * sample_rate)) / sample_rate
    course = artefact.course(t, np.random.default_rng(7))
    half_range = (np.array(profile.high) - np.array(profile.low)) / 2.0
    size = np.zeros(len(half_range))
    for joint in profile.joints:
        if artefact.all_joints or joint.name == "right_elbow":
            channels = list(joint.channels)
            size[channels] = half_range[channels] * (np.sign(joint.direction) if artefact.along else 1.0)
    return np.asarray(np.outer(course, size), dtype=np.float64)


def worst(
    subjects: Sequence[Subject], artefacts: Sequence[Artefact], mode: ControlMode, feature: Feature
) -> tuple[float, float]:
    """Return the largest speed (m/s) and the longest way (m) that an artefact gives the chair of any subject."""
    each = [outcome(in_mode(one, mode, feature), artefact) for one in subjects for artefact in artefacts]
    return max(one.speed for one in each), max(one.way for one in each)


class Row(NamedTuple):
    """A row of the table: the worst of some artefacts."""

    words: str
    artefacts: Sequence[Artefact]
    subjects: Sequence[Subject]


def rows() -> list[Row]:
    """Return the rows of the table."""
    subjects = [subject(kind) for kind in get_args(StudyMap)]
    found = [Row(one.words, [one], subjects) for one in (*ARTEFACTS, *hums(100.0), *ONE_JOINT_SWAYS)]
    for rate in (48.0, 50.0, 51.0, 60.0, 200.0, 1000.0):
        judged = [subject("pca", rate)]
        found.append(Row(f"{ARTEFACTS[1].words} at {rate:g} Hz", [ARTEFACTS[1]], judged))
        found.append(Row(f"largest of all hums: at {rate:g} Hz", list(hums(rate)), judged))
    return found


def cell(speed: float, way: float) -> str:
    """Return speed (m/s) and way (m) as they stand in the table: 0 where both round to it."""
    text = f"{speed:.2f}, {way:.2f}"
    return "0" if text == "0.00, 0.00" else text


def merged(rows: Iterable[tuple[str, tuple[str, ...]]]) -> list[str]:
    """Return lines of the table; artefacts of one kind with equal cells share a line."""
    details: dict[tuple[str, tuple[str, ...]], list[str]] = {}
    for words, cells in rows:
        kind, _, detail = words.partition(": ")
        details.setdefault((kind, cells), []).append(detail)
    return [f"| {kind}: {'; '.join(those)} | {' | '.join(cells)} |\n" for (kind, cells), those in details.items()]


def main() -> None:
    """Print the table."""
    kinds = tuple(itertools.product(get_args(ControlMode), get_args(Feature)))
    judged = (
        (row.words, tuple(cell(*worst(row.subjects, row.artefacts, mode, feature)) for mode, feature in kinds))
        for row in rows()
    )
    sys.stdout.write("| artefact | " + " | ".join(f"{mode}, {feature}" for mode, feature in kinds) + " |\n")
    sys.stdout.write("|---|" + "---|" * len(kinds) + "\n")
    sys.stdout.writelines(merged(judged))


if __name__ == "__main__":
    main()
