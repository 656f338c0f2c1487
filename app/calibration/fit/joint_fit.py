"""Fits the map of one joint: direction, sign, span, dead-zone and full of its gesture, least steps that count."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.dead_zone import LARGEST_DEAD_ZONE, dead_zone_over, full_over
from app.calibration.fit.joint_evidence import (
    Direction,
    full_rate,
    percentile_span,
    prompt_sign,
    prompted_span,
    rate_along,
    rate_of,
    repeatability,
    rest_rate,
    with_lag,
)
from app.calibration.fit.pca import JointPCA, angle_between
from app.calibration.fit.repetitions import Repetition
from app.calibration.gaps import Frames
from app.calibration.map_grades import LARGEST_ANGLE
from app.calibration.signal_steps import STEEPNESS, steps_of

SPAN_FACTOR = 1.25  # of the free movement's span: prompts that go further than this set the span
LARGEST_STEP = 0.3  # FS
QUIET_QUANTILE = 0.3  # quantile of the changes of a piece that is taken for its noise: people rest for that part of it
STEP_NOISE_FACTOR = 4.5  # of the usual change within the time of a sudden step
TREMOR_QUANTILE = 0.95  # quantile of the changes at rest: a large cycle of a tremor
TREMOR_FACTOR = 2.0  # of the change of such a cycle within the time of a filtered step
STEP_MARGIN = 1.2  # of the largest step of the calibration


class LeastSteps(NamedTuple):
    """The least steps (FS) of a joint that count."""

    sudden: float
    filtered: float


SMALLEST_STEPS = LeastSteps(0.03, 0.06)  # smaller ones hardly drive


@dataclass(frozen=True, slots=True)
class FittedJoint:
    """The fitted map of one joint, without its cross-talk, which needs the maps of all joints."""

    direction: Direction
    sign: int
    span: float
    evr: float
    angle_deg: float | None
    agreement: float | None
    prompted_share: float | None
    span_from_prompts: bool
    rest_rate: float
    dead_zone: float
    full: float
    reaches_full: bool
    repeatability: float | None
    steps: LeastSteps

    def rate(self, values: Frames, sample_rate: float) -> Frames:
        """Return the rate (n,) in FS/s of frames (n, n_channels)."""
        return rate_of(self.direction, values, self.sign / self.span, sample_rate)


def fit_joint(
    channels: tuple[int, ...], free: Frames, rest: Frames | None, repetitions: Sequence[Repetition], sample_rate: float
) -> FittedJoint:
    """Return the map of one joint from frames (n, n_channels) without NaN; `repetitions` are those of the joint."""
    pca = JointPCA(channels).fit(free)
    direction = Direction(channels, pca.direction, pca.mean_)
    angle = None
    prompted = _prompted_direction(channels, repetitions, sample_rate)
    if prompted is not None:
        angle = angle_between(direction.weights, prompted)
        if angle > LARGEST_ANGLE:
            direction = Direction(channels, prompted, pca.mean_)
    place = direction.place(free)
    free_span = percentile_span(place)
    own_span = prompted_span(direction, repetitions) if repetitions else 0.0
    from_prompts = own_span > SPAN_FACTOR * free_span
    span = own_span if from_prompts else free_span
    pointing = prompt_sign(direction, repetitions, span, sample_rate) if repetitions else None
    # Without prompts the sign is arbitrary: a positive weight of the heaviest channel makes it reproducible.
    sign = pointing.sign if pointing else (1 if direction.weights[np.abs(direction.weights).argmax()] > 0 else -1)
    scale = sign / span
    quiet = rate_along(place if rest is None else direction.place(rest), scale, sample_rate)
    noise = min(rest_rate(quiet, sample_rate, at_rest=rest is not None), LARGEST_DEAD_ZONE)
    dead_zone = dead_zone_over(noise)
    if repetitions:
        rates = [
            rate_of(direction, repetition.values, scale, sample_rate)[with_lag(repetition, sample_rate)]
            for repetition in repetitions
        ]
    else:
        rates = [np.abs(quiet if rest is None else rate_along(place, scale, sample_rate))]
    reached = full_rate(rates, dead_zone)
    full = full_over(dead_zone, reached or 0.0)
    return FittedJoint(
        direction=direction,
        sign=sign,
        span=span,
        evr=float(pca.explained_variance_ratio_[0]),
        angle_deg=angle,
        agreement=pointing.agreement if pointing else None,
        prompted_share=own_span / span if repetitions else None,
        span_from_prompts=from_prompts,
        rest_rate=noise,
        dead_zone=dead_zone,
        full=full,
        reaches_full=reached is not None,
        repeatability=repeatability(rates, sample_rate) if repetitions else None,
        steps=least_steps(channels, span, free, rest, repetitions, sample_rate),
    )


def _prompted_direction(
    channels: tuple[int, ...], repetitions: Sequence[Repetition], sample_rate: float
) -> NDArray[np.float64] | None:
    """Return PC1 (k,) of the prompted movements about their own means (because of drift); None for too few rows."""
    moved = [repetition.values[with_lag(repetition, sample_rate)] for repetition in repetitions]
    if sum(map(len, moved)) <= 3 * len(channels):
        return None
    return JointPCA(channels).fit(np.concatenate([piece - piece.mean(axis=0) for piece in moved])).direction


def least_steps(
    channels: Sequence[int],
    span: float,
    free: Frames,
    rest: Frames | None,
    repetitions: Sequence[Repetition],
    sample_rate: float,
) -> LeastSteps:
    """Return the least steps of a joint, from frames (n, n_channels) of free movement, of rest, and of its prompts."""
    least = list(SMALLEST_STEPS)
    for piece in (free, rest, *(repetition.values for repetition in repetitions)):
        if piece is None:
            continue
        changes = [step / span for step in steps_of(piece, channels, sample_rate)]
        for kind, (after, at, before) in enumerate(changes):
            steep = at[at > STEEPNESS * np.maximum(after, before)]
            least[kind] = max(least[kind], STEP_MARGIN * float(steep.max(initial=0.0)))
        (_, sudden, _), (_, filtered, _) = changes
        if (piece is free or piece is rest) and len(sudden):  # nobody rests during prompts
            least[0] = max(least[0], STEP_NOISE_FACTOR * float(np.quantile(sudden, QUIET_QUANTILE)))
        if piece is rest and len(filtered):
            least[1] = max(least[1], TREMOR_FACTOR * float(np.quantile(filtered, TREMOR_QUANTILE)))
    return LeastSteps(*(round(min(step, LARGEST_STEP), 4) for step in least))
