"""A recording of one person whose movement is known, and the figures of a map on it."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.fit.repetitions import Prompt, Stretch, stretches_of_prompts
from app.calibration.gestures.prediction import HIT_ACTIVATION
from app.calibration.linear_map import MapKind
from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import standard_parameters
from app.layout import ShirtLayout
from app.pipeline.replay.batch import decode_block
from app.signals.low_pass import STANDARD_CUTOFF, smooth

RISING, STILL = 0.1, 0.03  # of the movement's span per second: above it the joint moves up, below it it is still
SHORTEST_STROKE = 0.1  # s
LARGE = 0.3  # of the span: what counts as a stroke
MARGIN = 0.3  # s of stillness around what counts as rest
JUDGED_FROM = 20.0  # s after the first frame of the joint's part: before it the calibration takes place
OWN_PROMPTS = (0.0, 5.0, 10.0, 20.0)  # s of a person's own prompted movement, after each of which maps are compared
TABLE_HEAD = (
    "| own prompts | map | in phase: median / 10th percentile / worst | hits: all / worst recording | time active | "
    "false per min |\n|---|---|---|---|---|---|"
)

Array = NDArray[np.float64]


class Movement(NamedTuple):
    """What a joint does, as measured: rows of the recording."""

    rising: NDArray[np.bool_]  # (n,)
    still: NDArray[np.bool_]  # (n,)
    strokes: list[tuple[int, int]]  # large rising stretches


@dataclass(frozen=True, slots=True)
class JointPart:
    """The part of a recording in which one joint is prompted."""

    joint: str
    rows: slice
    prompts: tuple[Prompt, ...]
    movement: Movement


@dataclass(frozen=True, slots=True)
class Wearer:
    """One recording of one person."""

    code: str  # of the person
    group: str  # people of one group are never in each other's pool
    layout: ShirtLayout
    sample_rate: float
    t: Array
    values: Array  # (n, n_channels)
    free: slice  # ten seconds of any movement
    parts: tuple[JointPart, ...]

    def with_values(self, values: Array) -> "Wearer":
        """Return the recording with other values."""
        return replace(self, values=values)


class Figures(NamedTuple):
    """The figures of a map on one joint of one recording."""

    in_phase: float
    hit: float  # share of the movements that reach half of a full activation
    active: float  # share of the time of the movements with activation
    false_per_minute: float


def prompted_stretches(wearer: Wearer, prompts: Sequence[Prompt], until: float | None = None) -> list[Stretch]:
    """Return one stretch per joint, of the prompts that end before `until` (s); None: of all."""
    return stretches_of_prompts(wearer.t, wearer.values, prompts, wearer.sample_rate, until, longest_pause=np.inf)


def movement_of(place: Array, sample_rate: float) -> Movement:
    """Return what a joint does from its measured place (n,), in any unit, smoothed as the signals: both lag equally."""
    smoothed = smooth(place, STANDARD_CUTOFF, sample_rate)
    span = float(np.ptp(place))
    rate = np.diff(smoothed, prepend=smoothed[:1]) * sample_rate / span
    rising = rate > RISING
    edges = np.flatnonzero(np.diff(rising.astype(np.int8), prepend=0, append=0))
    strokes = [
        (int(start), int(stop))
        for start, stop in zip(edges[::2], edges[1::2], strict=True)
        if stop - start > SHORTEST_STROKE * sample_rate and smoothed[stop - 1] - smoothed[start] > LARGE * span
    ]
    around = 2 * round(MARGIN * sample_rate) + 1
    moving = np.convolve(np.abs(rate) > STILL, np.ones(around), "same") > 0.5
    return Movement(rising, ~moving, strokes)


def figures(wearer: Wearer, part: JointPart, profile: CalibrationProfile, kind: MapKind) -> Figures:
    """Return the figures of the profile's map of one kind from JUDGED_FROM on, as `decode` gives its activation."""
    joints = tuple(joint.model_copy(update={"map": kind}) for joint in profile.joints if joint.name == part.joint)
    parameters = standard_parameters(profile.model_copy(update={"joints": joints, "cross_talk": None}))
    rows = part.rows
    decoded = decode_block(parameters, wearer.sample_rate, wearer.t[rows], wearer.values[rows].astype(np.float32))
    return figures_of(wearer, part, decoded.activation[:, 0])


def figures_of(wearer: Wearer, part: JointPart, decoded: Array) -> Figures:
    """Return the figures of an activation (n,) over the rows of a joint's part."""
    activation = decoded.copy()
    first = round(JUDGED_FROM * wearer.sample_rate)
    activation[:first] = 0.0
    total = float(activation.sum())
    in_stroke = np.zeros(len(activation), np.bool_)
    for start, stop in part.movement.strokes:
        in_stroke[start:stop] = start >= first
    later = [(start, stop) for start, stop in part.movement.strokes if start >= first]
    reached = [activation[start:stop].max() >= HIT_ACTIVATION for start, stop in later]
    resting = part.movement.still.copy()
    resting[:first] = False
    begins = np.diff(((activation > 0.0) & resting).astype(np.int8), prepend=0) > 0
    minutes = float(resting.sum()) / wearer.sample_rate / 60.0
    return Figures(
        float(activation[part.movement.rising].sum()) / total if total else 0.0,
        float(np.mean(reached)),
        float((activation[in_stroke] > 0.0).mean()),
        float(begins.sum()) / minutes if minutes else 0.0,
    )


def summary(rows: Sequence[Figures]) -> str:
    """Return the cells of a table: share in phase, hits, time active, false activations a minute."""
    in_phase, hit, active, false = np.array(rows).T
    tenth = np.percentile(in_phase, 10)
    return (
        f"{np.median(in_phase):.3f} / {tenth:.3f} / {in_phase.min():.2f} | {hit.mean():.3f} / {hit.min():.2f} | "
        f"{np.median(active):.2f} | {false.mean():.1f}"
    )
