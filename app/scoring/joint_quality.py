"""Quality of one joint in a trial: direction of its movement, share that the map decodes, span, noise at rest."""

from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from app.calibration.fit.joint_evidence import percentile_span
from app.calibration.fit.pca import JointPCA, angle_between
from app.calibration.profile import JointMap
from app.layout import ShirtLayout
from app.quantities import Count, Document, Fraction, Name, Title
from app.scoring.stops_and_pulses import ON
from app.signals.low_pass import STANDARD_CUTOFF, smooth

LEAST_TIME = 2.0  # s of usable signal; with less, no figure is computed
LEAST_MOVEMENT = 2.0  # s of movement in a trial, about five strokes; with less, no direction is computed
SHORTEST_STRETCH = 0.1  # s; a shorter stretch of movement is a twitch
SETTLING = 0.3  # s after which the low-pass no longer depends on its first sample
STILL = 0.5  # s, length of the stretches of which some are taken as rest
STILL_SHARE = 0.2  # of the stretches, the stillest ones, are rest: driving by strokes leaves each limb more rest

Numbers = NDArray[np.float64]
Flags = NDArray[np.bool_]
Amount = Annotated[float, Field(ge=0, le=1e12, allow_inf_nan=False)]
Degrees = Annotated[float, Field(ge=0, le=90)]


class JointQuality(Document):
    """The quality of one joint in one trial; None for figures that need more movement or more usable signal."""

    name: Name
    label: Title  # the joint's name for people
    channels: tuple[Name, ...]  # that its map reads
    dead_zone: Amount | None = None  # FS/s, the smallest of its gestures that read the PCA map's rate
    guided: bool = False  # a guided map, or one from other people, decodes it: these figures are those of its PCA map
    map_angle_deg: Degrees | None = None  # between the trial's own PC1 and the map
    evr: Fraction | None = None  # share of the trial's movement that its own PC1 explains
    null_space_share: Fraction | None = None  # share of the movement across the map, which never reaches the control
    span: Amount | None = None  # signal units, 1st to 99th percentile along the map
    span_share: Amount | None = None  # `span` over the profile's span
    rest_rate: Amount | None = None  # FS/s, noise of the rate at rest
    moved: Amount = 0.0  # s of movement
    activations: Count = 0
    direction: dict[str, float] | None = None  # the trial's own PC1 per channel: unit length, pointing as the map does


class MapFit(NamedTuple):
    """How well a map's direction agrees with a movement."""

    angle_deg: float  # between the movement's PC1 and the map, 0..90
    evr: float
    null_space_share: float
    direction: Numbers  # (k,) PC1, turned so that it points as the map does


def joint_quality(
    joint: JointMap,
    channels: list[int],
    layout: ShirtLayout,
    values: Numbers,
    usable: Flags,
    sample_rate: float,
    activations: int,
    dead_zone: float | None = None,
) -> JointQuality:
    """Return the quality of one joint in a trial.

    Parameters
    ----------
    joint
        The joint's map.
    channels
        Indices of the joint's channels that were not bad.
    layout
        The shirt's; it gives the names of joint and channels.
    values
        (n, n_channels) signal units, without missing samples.
    usable
        (n,) where motion was permitted and none of `channels` was bad.
    sample_rate
        Hz.
    activations
        Number of activations of the joint's gestures.
    dead_zone
        FS/s, the smallest dead-zone of the joint's gestures.
    """
    names = layout.channel_names
    guided = joint.map != "pca"
    weights = np.array([joint.direction[joint.channels.index(channel)] for channel in channels])
    length = float(np.linalg.norm(weights))
    quality = JointQuality(
        name=joint.name,
        label=layout.joint_labels[joint.name],
        channels=tuple(names[index] for index in joint.channels),
        dead_zone=None if guided else dead_zone,
        guided=guided,
        activations=activations,
    )
    if length == 0 or np.count_nonzero(usable) < LEAST_TIME * sample_rate:
        return quality
    smoothed = smooth(values[:, channels], STANDARD_CUTOFF, sample_rate)
    rates = np.diff(smoothed, axis=0, prepend=smoothed[:1]) * (sample_rate / joint.span)
    # A joint moves when its rate, in any direction, is that of a command along the map; leakage from other joints is
    # slower.
    least = joint.pca.dead_zone + ON * (joint.pca.full - joint.pca.dead_zone)
    moving = usable & (np.linalg.norm(rates, axis=1) > least)
    fit = map_fit(smoothed, moving, weights / length, sample_rate)
    place = smoothed[usable] @ weights
    span = percentile_span(place)
    figures: dict[str, object] = {
        "span": span,
        "span_share": span / joint.span,
        "rest_rate": rest_noise(rates @ weights, usable, sample_rate),
        "moved": float(np.count_nonzero(moving)) / sample_rate,
    }
    if fit is not None:
        figures |= {"map_angle_deg": fit.angle_deg, "evr": fit.evr, "null_space_share": fit.null_space_share}
        figures["direction"] = {names[i]: float(part) for i, part in zip(channels, fit.direction, strict=True)}
    return quality.model_copy(update=figures)


def map_fit(values: Numbers, moving: Flags, weights: Numbers, sample_rate: float) -> MapFit | None:
    """Return how well a map agrees with a movement, None for less than 2 s of movement.

    The mean of each stretch of movement is subtracted, so that the fabric's slow drift between stretches does not
    count. With C the covariance of all stretches together and l1 its largest eigenvalue, evr = l1 / tr C, and the share
    of the null space is 1 - w C w / tr C: at least 1 - evr, and equal to it where map and movement agree.

    Parameters
    ----------
    values
        (n, k) a joint's channels, signal units.
    moving
        (n,) where the joint moves.
    weights
        (k,) the map, unit length.
    sample_rate
        Hz.
    """
    pieces = [values[part] - values[part].mean(axis=0) for part in stretches(moving, SHORTEST_STRETCH * sample_rate)]
    rows = sum(map(len, pieces))
    if rows < max(LEAST_MOVEMENT * sample_rate, 3 * len(weights)):
        return None
    moved = np.concatenate(pieces)
    if not moved.any():
        return None
    pca = JointPCA(range(len(weights))).fit(moved)
    first = pca.direction
    explained = float(pca.explained_variance_ratio_ @ (pca.components_ @ weights) ** 2)
    return MapFit(
        angle_deg=angle_between(first, weights),
        evr=min(1.0, float(pca.explained_variance_ratio_[0])),
        null_space_share=min(1.0, max(0.0, 1.0 - explained)),
        direction=first if first @ weights >= 0 else -first,
    )


def stretches(flags: Flags, shortest: float) -> list[slice]:
    """Return the runs of True in `flags` (n,) that hold at least `shortest` samples."""
    edges = np.flatnonzero(np.diff(flags.astype(np.int8), prepend=0, append=0)).tolist()
    return [slice(start, end) for start, end in zip(edges[::2], edges[1::2], strict=True) if end - start >= shortest]


def rest_noise(rate: Numbers, usable: Flags, sample_rate: float) -> float | None:
    """Return the noise of a rate (n,) at rest; None with fewer than five half-second stretches.

    That is the median of the standard deviations of the stillest fifth of all half-second stretches. No fixed limit
    decides what rest is, so that a growing tremor shows as growing noise.
    """
    length = max(2, round(STILL * sample_rate))
    settled = usable.copy()
    settled[: round(SETTLING * sample_rate)] = False
    deviations = [
        float(rate[start : start + length].std())
        for part in stretches(settled, length)
        for start in range(part.start, part.stop - length + 1, length)
    ]
    count = int(len(deviations) * STILL_SHARE)
    return float(np.median(sorted(deviations)[:count])) if count else None
