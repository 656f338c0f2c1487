"""The calibration profile: the map of one body in one shirt, as a versioned document."""

import operator
from typing import Annotated, Any, Literal, Self

from pydantic import Field, SerializerFunctionWrapHandler, model_serializer, model_validator

from app.layout import MAX_CHANNELS, MAX_JOINTS, ShirtLayout, is_missing
from app.quantities import Document, Finite, Fraction, Hertz, Name, Threshold

Grade = Literal["good", "usable", "repeat"]

Numbers = Annotated[tuple[Finite, ...], Field(max_length=MAX_CHANNELS)]
Span = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, le=1e12)]
Covariances = Annotated[
    tuple[Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-1e24, le=1e24)], ...],
    Field(max_length=MAX_CHANNELS),
]
Noise = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=1e12)]

MapKind = Literal["pca", "guided", "prior"]

# s: time constants of the two slow averages that a linear map subtracts from a channel's level; they are those of the
# fabric's relaxation.
AVERAGING_TIMES = (1.5, 10.0)
# s: ages of the rates that a prior's map reads; the joint's recent past tells a stroke from its way back.
RATE_LAGS = (0.0, 0.05, 0.1, 0.15, 0.2)
LEAST_GAIN = 0.01  # of in-phase share that a guided map must gain over the PCA map
LARGEST_LOSS = 0.03  # of the hit rate that a guided map may lose
FEWEST_JUDGED = 3  # repetitions: what one or two say of a map does not agree with how it does later
LEAST_HITS = 0.25  # hit rate on a person's own repetitions below which a map from other people is not offered
MOSTLY_IN_PHASE = 0.5  # in-phase share below which it is not: most of the activation would come without the movement


class Arrangement(Document):
    """How a ring of sensors sits on the body: turned by so many places, and perhaps mirrored."""

    # At place p of the ring lies the sensor that belongs at place p + shift.
    shift: Annotated[int, Field(strict=True, ge=0, lt=MAX_CHANNELS)] = 0
    mirrored: bool = False


class MapCheck(Document):
    """The check of one map on held-out repetitions (docs/learning/guided-map.md)."""

    in_phase: Fraction  # share of all activation during the prompted movements
    hit_rate: Fraction  # share of the time of the prompted movements with activation; of movements: `PriorMap.hits`
    false_per_minute: Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=1e6)]  # activations at rest
    false_count: Annotated[int, Field(strict=True, ge=0)]  # number of activations at rest


class LinearMap(Document):
    """A linear map: low-pass(rate . dx/dt + short . (x - slow x) + long . (x - slower x)).

    Scaled so that the prompted movements have the same rate in FS/s as with the joint's PCA map.
    """

    rate: Numbers  # FS per signal unit; one per entry of the joint's `channels`, like the next two
    short: Numbers  # FS/s per signal unit, of the level above its average over AVERAGING_TIMES[0]
    long: Numbers  # FS/s per signal unit, of the level above its average over AVERAGING_TIMES[1]
    dead_zone: Threshold  # FS/s, suggested
    full: Threshold  # FS/s, suggested

    @property
    def rates(self) -> tuple[tuple[float, ...], ...]:
        """The weights (FS per signal unit) of the rates as they were RATE_LAGS ago, or of the newest rates only."""
        return (self.rate,)

    @property
    def parts(self) -> tuple[tuple[float, ...], ...]:
        """All weights, one number per channel in each part: those of the rates, then `short` and `long`."""
        return (*self.rates, self.short, self.long)


class GuidedMap(LinearMap):
    """A linear map fitted to the prompts, with its check on held-out repetitions."""

    lag: Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-10, le=10)]  # s of the person behind the cues
    repetitions: Annotated[int, Field(strict=True, ge=1)]
    pca_check: MapCheck
    guided_check: MapCheck

    @property
    def is_better(self) -> bool:
        """Whether the guided map beats the PCA map on the held-out repetitions and may be offered."""
        pca, guided = self.pca_check, self.guided_check
        return (
            guided.in_phase >= pca.in_phase + LEAST_GAIN
            and guided.hit_rate >= pca.hit_rate - LARGEST_LOSS
            and guided.false_count <= pca.false_count + 1
        )


class Forecast(Document):
    """What is expected of a map in use, with its uncertainty (one standard deviation)."""

    value: Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=1e4)]
    uncertainty: Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=1e4)]


class PriorMap(LinearMap):
    """A linear map learnt from other people, alone or together with this person's own prompted movements.

    Besides the newest rates it reads those of 50 to 200 ms ago (`earlier`, one part for each further one of RATE_LAGS).
    """

    earlier: Annotated[tuple[Numbers, ...], Field(min_length=len(RATE_LAGS) - 1, max_length=len(RATE_LAGS) - 1)]
    people: Annotated[int, Field(strict=True, ge=1)]  # how many other people it is learnt from
    repetitions: Annotated[int, Field(strict=True, ge=0)]  # of this person's own; 0: from other people alone
    dropped: tuple[Name, ...] = ()  # channels that moved too little on this person and have no weight
    # Per ring of the layout that was found to sit otherwise than on other people: the weights go by this.
    arrangement: dict[Name, Arrangement] = Field(default_factory=dict)
    # Per ring that looked so, and that a person is sure sits right: the weights go by the layout. Left out where it is
    # empty, so that profiles from before keep their hash.
    as_worn: dict[Name, Arrangement] = Field(default_factory=dict, exclude_if=operator.not_)
    hits: Forecast | None = None  # of 100 movements, how many should reach half of a full activation; None: not known
    false_per_minute: Forecast | None = None  # expected activations without a prompt; None: not known
    prior_check: MapCheck | None = None  # on this person's own held-out repetitions; None without any
    pca_check: MapCheck | None = None  # of the joint's PCA map, on the same frames

    @property
    def rates(self) -> tuple[tuple[float, ...], ...]:
        """The weights (FS per signal unit) of the rates as they were RATE_LAGS ago."""
        return (self.rate, *self.earlier)

    @property
    def source(self) -> str:
        """Where the map comes from, in words."""
        return "from other people and own movement" if self.repetitions else "from other people"

    @property
    def is_better(self) -> bool:
        """Whether nothing says that the PCA map is better on this person's own repetitions.

        Fewer hits alone do not: the dead-zone is other people's, and that of PCA is fitted to these repetitions. They
        do where nothing is gained in phase. A map that mostly acts outside of the movement is never better, also where
        the PCA map does not act at all.
        """
        prior, pca = self.prior_check, self.pca_check
        if prior is None or pca is None or self.repetitions < FEWEST_JUDGED:
            return True
        gain, loss = prior.in_phase - pca.in_phase, pca.hit_rate - prior.hit_rate
        gains_nothing = gain < LEAST_GAIN and loss > LARGEST_LOSS
        does_its_work = prior.in_phase >= MOSTLY_IN_PHASE and prior.hit_rate >= LEAST_HITS
        return does_its_work and gain >= -LARGEST_LOSS and not gains_nothing


class JointMap(Document):
    """The map of one joint: score = sign * weights . (x[channels] - mean) / span."""

    name: Name
    channels: Annotated[tuple[int, ...], Field(min_length=1, max_length=MAX_CHANNELS)]  # indices into a frame
    weights: Numbers  # unit length, one per entry of `channels`
    mean: Numbers
    sign: Literal[1, -1]
    span: Span  # signal units per FS: 1st to 99th percentile of the PC
    evr: Fraction  # explained variance ratio of PC1 in free movement
    prompted: bool  # whether prompts fixed the sign; otherwise it is arbitrary
    angle_deg: Annotated[float, Field(ge=0, le=90)] | None = None  # between the free and the prompted PC1
    signal_to_noise: Annotated[float, Field(ge=0)] | None = None
    repeatability: Annotated[float, Field(ge=0)] | None = None  # spread of the repetitions' peaks / their mean
    rest_rate: Threshold  # FS/s, standard deviation of the rate at rest
    dead_zone: Threshold  # FS/s, suggested
    full: Threshold  # FS/s, suggested
    # FS: larger changes from one rest to another are no movement, within 0.02 s and within 0.1 s; None: unknown.
    step: Threshold | None = None
    filtered_step: Threshold | None = None
    grade: Grade
    reason: str
    map: MapKind = "pca"  # the map that gives the rate; the score is always that of PC1
    guided: GuidedMap | None = None  # the fitted guided map, with its check
    prior: PriorMap | None = None  # the map learnt from other people
    # (k, k) of the channels' movement in the calibration, squared signal units: it tells what a bad channel would show,
    # and how exactly that is known. None, and left out for their hash, in profiles from before it was stored.
    covariance: Annotated[tuple[Covariances, ...], Field(max_length=MAX_CHANNELS)] | None = Field(
        default=None, exclude_if=is_missing
    )

    @model_validator(mode="after")
    def _lengths_agree(self) -> Self:
        if not len(self.channels) == len(self.weights) == len(self.mean):
            raise ValueError(f"joint '{self.name}': channels, weights and mean must be of one length")
        for kind, linear in (("guided", self.guided), ("prior", self.prior)):
            if linear is None:
                if self.map == kind:
                    raise ValueError(f"joint '{self.name}': its map is '{kind}', but it has no {kind} map")
            elif any(len(part) != len(self.channels) for part in linear.parts):
                raise ValueError(f"joint '{self.name}': the {kind} map must have one number per channel in each part")
        if self.covariance is not None:
            self._check_covariance(self.covariance)
        return self

    def _check_covariance(self, covariance: tuple[tuple[float, ...], ...]) -> None:
        count = len(self.channels)
        if len(covariance) != count or any(len(row) != count for row in covariance):
            raise ValueError(f"joint '{self.name}': the covariance must have {count} rows of {count} numbers")
        if any(covariance[i][j] != covariance[j][i] for i in range(count) for j in range(i)):
            raise ValueError(f"joint '{self.name}': the covariance must be symmetric")
        if any(covariance[i][i] < 0.0 for i in range(count)):
            raise ValueError(f"joint '{self.name}': the covariance has a variance below 0")

    @model_serializer(mode="wrap")
    def _without_defaults(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """Leave out default values, so that profiles from before the linear maps keep their hash."""
        document: dict[str, Any] = handler(self)
        if document.get("map") == "pca":
            del document["map"]
        for name in ("guided", "prior", "step", "filtered_step"):
            if document.get(name, ...) is None:
                del document[name]
        return document

    @property
    def has_to_be_repeated(self) -> bool:
        """Whether the measurements say that the movement is too weak or too uneven to drive with."""
        return self.grade == "repeat"

    @property
    def advice(self) -> str | None:
        """What is to be heeded; None when the measurements are good."""
        return None if self.grade == "good" else self.reason

    @property
    def linear(self) -> LinearMap | None:
        """The linear map that decodes; None when the PCA map does."""
        return {"pca": None, "guided": self.guided, "prior": self.prior}[self.map]

    @property
    def best_map(self) -> MapKind:
        """The map to offer: that of other people, or else the guided one, each unless its checks speak against it."""
        if self.prior is not None and self.prior.is_better:
            return "prior"
        return "guided" if self.guided is not None and self.guided.is_better else "pca"

    @property
    def has_direction(self) -> bool:
        """Whether it is known which way the gesture goes: by prompts, or by other people."""
        return self.prompted or self.map == "prior"

    @property
    def thresholds(self) -> tuple[float, float]:
        """Dead-zone and full (FS/s) that the calibration suggests for the chosen map."""
        chosen = self.linear or self
        return chosen.dead_zone, chosen.full


class CalibrationProfile(Document):
    """The saved result of a calibration; never changed, only succeeded by a newer version."""

    format: Literal["bodydrive-profile"] = "bodydrive-profile"
    version: Literal[1] = 1
    created: str  # UTC, ISO 8601
    software: str  # version of bodydrive that made it
    layout: ShirtLayout
    sample_rate: Hertz
    left_out: dict[str, str]  # channel name -> why it is not in the map
    low: Numbers  # (n_channels,) smallest value in the calibration
    high: Numbers  # (n_channels,) largest value in the calibration
    # (n_channels,) standard deviation of each channel's noise in the calibration, signal units: a channel that shows
    # much less of it is stuck. None in profiles from before it was stored.
    noise: Annotated[tuple[Noise, ...], Field(max_length=MAX_CHANNELS)] | None = Field(
        default=None, exclude_if=is_missing
    )
    joints: Annotated[tuple[JointMap, ...], Field(min_length=1, max_length=MAX_JOINTS)]
    cross_talk: tuple[tuple[Finite, ...], ...] | None = None
    """Row: joint that was prompted; column: joint that answered, as a share of its activation when prompted itself.

    1.0 on the diagonal; 0.0 where one of the two was never prompted (`JointMap.prompted`). None without prompts.
    """

    @model_validator(mode="after")
    def _channels_exist(self) -> Self:
        count = len(self.layout.channels)
        if not len(self.low) == len(self.high) == count:
            raise ValueError(f"low and high must have {count} numbers, one per channel of the layout")
        if self.noise is not None and len(self.noise) != count:
            raise ValueError(f"noise must have {count} numbers, one per channel of the layout")
        for joint in self.joints:
            if any(not 0 <= index < count for index in joint.channels):
                raise ValueError(f"joint '{joint.name}' reads a channel that the layout does not have")
        return self
