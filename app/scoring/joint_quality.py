"""What one joint did in a trial: which way it moved, how much of that the map sees, how far, how still its rest."""

from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from app.calibration.fit.joint_evidence import CUTOFF, percentile_span
from app.calibration.fit.pca import JointPCA, angle_between
from app.calibration.profile import JointMap
from app.layout import ShirtLayout
from app.quantities import Count, Document, Fraction, Name, Title
from app.scoring.command_counts import ON
from app.signals.smoothing import smooth

LEAST_TIME = 2.0  # s that can be looked at: with less, nothing is told
LEAST_MOVEMENT = 2.0  # s of movement in a trial, before its direction is told: a handful of strokes
SHORTEST_STRETCH = 0.1  # s; a shorter stretch of movement is a twitch
SETTLING = 0.3  # s: the low-pass forgets its first sample within it
STILL = 0.5  # s, length of the stretches among which rest is looked for
STILL_SHARE = 0.2  # the stillest fifth of them is rest: who drives by strokes rests each limb more than that

Numbers = NDArray[np.float64]
Flags = NDArray[np.bool_]
Amount = Annotated[float, Field(ge=0, le=1e12, allow_inf_nan=False)]
Degrees = Annotated[float, Field(ge=0, le=90)]


class JointQuality(Document):
    """One joint in one trial; None where it moved, or could be heard, too little to tell."""

    name: Name
    label: Title  # what people call it
    channels: tuple[Name, ...]  # that its map reads
    dead_zone: Amount | None = None  # FS/s, the smallest of its gestures that read the PCA map's rate
    guided: bool = False  # a guided map decodes it: these figures are those of its PCA map
    map_angle_deg: Degrees | None = None  # between the trial's own PC1 and the map
    evr: Fraction | None = None  # share of the trial's movement that its own PC1 explains
    null_space_share: Fraction | None = None  # of the movement: what lies across the map and never reaches the control
    span: Amount | None = None  # signal units, 1st to 99th percentile along the map
    span_share: Amount | None = None  # the same over the profile's span
    rest_rate: Amount | None = None  # FS/s, standard deviation of the rate where it was stillest
    moved: Amount = 0.0  # s
    activations: Count = 0
    direction: dict[str, float] | None = None  # the trial's own PC1 per channel: unit length, pointing as the map does


class MapFit(NamedTuple):
    """How a map lies in a movement."""

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
    """Return what one joint did.

    Parameters
    ----------
    joint
        Its map.
    channels
        Those of its channels that can be believed.
    layout
        Of the shirt: what joint and channels are called.
    values
        (n, n_channels) signal units, without holes.
    usable
        (n,) where motion was permitted and these channels can be believed.
    sample_rate
        Hz.
    activations
        How often its gestures were there.
    dead_zone
        FS/s, the smallest of its gestures.
    """
    names = layout.channel_names
    label = next(one.label for one in layout.joints if one.name == joint.name)
    guided = joint.map == "guided"
    weights = np.array([joint.weights[joint.channels.index(channel)] for channel in channels])
    length = float(np.linalg.norm(weights))
    known = JointQuality(
        name=joint.name,
        label=label,
        channels=tuple(names[index] for index in joint.channels),
        dead_zone=None if guided else dead_zone,
        guided=guided,
        activations=activations,
    )
    if length == 0 or np.count_nonzero(usable) < LEAST_TIME * sample_rate:
        return known
    smoothed = smooth(values[:, channels], CUTOFF, sample_rate)
    rates = np.diff(smoothed, axis=0, prepend=smoothed[:1]) * (sample_rate / joint.span)
    # Moving: as fast, whichever way, as a command along the map is; what leaks in from a neighbour is slower.
    least = joint.dead_zone + ON * (joint.full - joint.dead_zone)
    moving = usable & (np.linalg.norm(rates, axis=1) > least)
    fit = map_fit(smoothed, moving, weights / length, sample_rate)
    place = smoothed[usable] @ weights
    span = percentile_span(place)
    found: dict[str, object] = {
        "span": span,
        "span_share": span / joint.span,
        "rest_rate": rest_noise(rates @ weights, usable, sample_rate),
        "moved": float(np.count_nonzero(moving)) / sample_rate,
    }
    if fit is not None:
        found |= {"map_angle_deg": fit.angle_deg, "evr": fit.evr, "null_space_share": fit.null_space_share}
        found["direction"] = {names[i]: float(part) for i, part in zip(channels, fit.direction, strict=True)}
    return known.model_copy(update=found)


def map_fit(values: Numbers, moving: Flags, weights: Numbers, sample_rate: float) -> MapFit | None:
    """Return how a map lies in a movement, None for less than 2 s of it.

    Each stretch of movement counts about its own mean, so that the fabric's slow drift between them is no movement.
    With C the covariance so pooled, evr = l1 / tr C of its largest eigenvalue, and the share of the null space is
    1 - w C w / tr C: at least 1 - evr, and just that where map and movement agree.

    Parameters
    ----------
    values
        (n, k) a joint's channels.
    moving
        (n,) where it moves.
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
    first = pca.components_[0]
    seen = float(pca.explained_variance_ratio_ @ (pca.components_ @ weights) ** 2)
    return MapFit(
        angle_deg=angle_between(first, weights),
        evr=min(1.0, float(pca.explained_variance_ratio_[0])),
        null_space_share=min(1.0, max(0.0, 1.0 - seen)),
        direction=first if first @ weights >= 0 else -first,
    )


def stretches(flags: Flags, shortest: float) -> list[slice]:
    """Return the runs of True in `flags` (n,) that hold at least `shortest` samples."""
    edges = np.flatnonzero(np.diff(flags.astype(np.int8), prepend=0, append=0)).tolist()
    return [slice(start, end) for start, end in zip(edges[::2], edges[1::2], strict=True) if end - start >= shortest]


def rest_noise(rate: Numbers, usable: Flags, sample_rate: float) -> float | None:
    """Return the noise of a rate (n,) at rest: the median of the standard deviations of the stillest fifth of all
    half-second stretches; None where there are fewer than five such stretches.

    No limit says what rest is, so that a tremor that grows is seen growing.
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
