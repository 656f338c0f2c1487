"""The linear map of a joint's channels to the rate of its movement, as a document.

There are three ways to learn one, and one way to decode with it: the standard map is the main component (PCA) of free
movement, others are learnt from the person's own prompts, or from other people with or without own prompts.
"""

import operator
from collections.abc import Sequence
from typing import Annotated, Literal, TypedDict

from pydantic import Field

from app.layout import MAX_CHANNELS, is_missing
from app.quantities import Document, Finite, Fraction, Name, Threshold
from app.texts import Text

MapKind = Literal["pca", "guided", "prior"]

# s: ages of the rates that a map may read; a joint's recent past distinguishes a stroke from its way back.
RATE_LAGS = (0.0, 0.05, 0.1, 0.15, 0.2)
# s: time constants of the two slow averages above which levels are counted; they are those of the fabric's relaxation.
AVERAGING_TIMES = (1.5, 10.0)
KINDS = len(RATE_LAGS) + len(AVERAGING_TIMES)  # readings of one channel: rates by their age, then levels

LEAST_GAIN = 0.01  # of in-phase share that a map from own prompts must gain over the PCA map
LARGEST_LOSS = 0.03  # of the hit rate that it may lose
FEWEST_JUDGED = 3  # repetitions: one or two do not predict how well a map decodes later
LEAST_HITS = 0.25  # hit rate on a person's own repetitions below which a map from other people is not offered
MOSTLY_IN_PHASE = 0.5  # in-phase share below which it is not: most of the activation would come without the movement

Numbers = Annotated[tuple[Finite, ...], Field(max_length=MAX_CHANNELS)]
Count = Annotated[int, Field(strict=True, ge=0)]


class Arrangement(Document):
    """How a ring of sensors sits on the body: turned by so many places, and perhaps mirrored."""

    # At place p of the ring lies the sensor that belongs at place p + shift.
    shift: Annotated[int, Field(strict=True, ge=0, lt=MAX_CHANNELS)] = 0
    mirrored: bool = False


class MapCheck(Document):
    """The check of one map on held-out repetitions (docs/learning/guided-map.md)."""

    in_phase: Fraction  # share of all activation during the prompted movements
    hit_rate: Fraction  # share of the time of the prompted movements with activation; of movements: `LinearMap.hits`
    false_per_minute: Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=1e6)]  # activations at rest
    false_count: Count  # number of activations at rest


class Forecast(Document):
    """What is expected of a map in use, with its uncertainty (one standard deviation)."""

    value: Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=1e4)]
    uncertainty: Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=1e4)]


class MapParts(TypedDict):
    """The weights of a map, as its document has them."""

    rates: tuple[tuple[float, ...], ...]
    short: tuple[float, ...]
    long: tuple[float, ...]


def map_parts(weights: Sequence[Sequence[float]]) -> MapParts:
    """Return weights (KINDS, k), sorted as `LinearMap.parts`, without the parts that are zero."""
    *rates, short, long = (tuple(part) if any(part) else () for part in weights)
    read = max((index for index, part in enumerate(rates) if part), default=0) + 1
    zeros = (0.0,) * len(weights[0])
    return MapParts(rates=tuple(part or zeros for part in rates[:read]), short=short, long=long)


class LinearMap(Document):
    """A map from a joint's channels x to the rate of its movement, FS/s.

    rate(t) = low-pass(sum of rates[i] . dx/dt(t - RATE_LAGS[i]) + short . (x - slow x) + long . (x - slower x))

    Each part has one number per channel. The PCA map has the newest rates only; a map from own prompts reads levels
    beside them, and a map from other people also earlier rates. Parts that a map does not read are left out.
    """

    rates: Annotated[tuple[Numbers, ...], Field(min_length=1, max_length=len(RATE_LAGS))]  # FS per signal unit
    # FS/s per signal unit, of the level above its average over AVERAGING_TIMES[0], and over AVERAGING_TIMES[1]
    short: Numbers = Field(default=(), exclude_if=operator.not_)
    long: Numbers = Field(default=(), exclude_if=operator.not_)
    dead_zone: Threshold  # FS/s, suggested
    full: Threshold  # FS/s, suggested
    people: Count = Field(default=0, exclude_if=operator.not_)  # how many other people it is learnt from
    repetitions: Count = Field(default=0, exclude_if=operator.not_)  # of this person's own that it is learnt from
    # s of the person behind the cues; None where it was not estimated
    lag: Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-10, le=10)] | None = Field(
        default=None, exclude_if=is_missing
    )
    # On this person's own held-out repetitions; None without any. The PCA map's is on the same frames.
    check: MapCheck | None = Field(default=None, exclude_if=is_missing)
    pca_check: MapCheck | None = Field(default=None, exclude_if=is_missing)
    # Channels that moved too little on this person and have no weight.
    dropped: tuple[Name, ...] = Field(default=(), exclude_if=operator.not_)
    # Ring of the layout -> its detected arrangement, where it differs from other people's; the weights follow it.
    arrangement: dict[Name, Arrangement] = Field(default_factory=dict, exclude_if=operator.not_)
    # Ring -> its detected arrangement, which the clinician has overridden: the weights follow the layout.
    as_worn: dict[Name, Arrangement] = Field(default_factory=dict, exclude_if=operator.not_)
    # Of 100 movements, how many should reach half of a full activation, and the expected activations a minute without
    # a prompt; None: not known.
    hits: Forecast | None = Field(default=None, exclude_if=is_missing)
    false_per_minute: Forecast | None = Field(default=None, exclude_if=is_missing)

    @property
    def parts(self) -> tuple[tuple[float, ...], ...]:
        """The weights (KINDS, k): of rates by age, then of the two levels; zero where the map reads none."""
        zeros = (0.0,) * len(self.rates[0])
        unread = (zeros,) * (len(RATE_LAGS) - len(self.rates))
        return (*self.rates, *unread, self.short or zeros, self.long or zeros)

    @property
    def source(self) -> Text:
        """What the map is learnt from, in words."""
        if self.people:
            return Text("calibration-source-both" if self.repetitions else "calibration-source-people")
        return Text("calibration-source-prompts" if self.repetitions else "calibration-source-standard")

    @property
    def is_better(self) -> bool:
        """Whether the map may be offered instead of the PCA map, as far as the held-out repetitions tell.

        A map from other people is offered unless enough repetitions are worse with it; a map from own prompts only
        where they are better with it.
        """
        linear, pca = self.check, self.pca_check
        if linear is None or pca is None:
            return self.people > 0
        if not self.people:
            return (
                linear.in_phase >= pca.in_phase + LEAST_GAIN
                and linear.hit_rate >= pca.hit_rate - LARGEST_LOSS
                and linear.false_count <= pca.false_count + 1
            )
        if self.repetitions < FEWEST_JUDGED:
            return True
        # A map from other people may have fewer hits than PCA: its dead-zone is other people's, and that of PCA is
        # fitted to these repetitions. It is rejected where it has fewer hits and gains no in-phase share either. A map
        # whose activation lies mostly outside of the movement is rejected also where the PCA map is never active.
        gain, loss = linear.in_phase - pca.in_phase, pca.hit_rate - linear.hit_rate
        gains_nothing = gain < LEAST_GAIN and loss > LARGEST_LOSS
        does_its_work = linear.in_phase >= MOSTLY_IN_PHASE and linear.hit_rate >= LEAST_HITS
        return does_its_work and gain >= -LARGEST_LOSS and not gains_nothing
