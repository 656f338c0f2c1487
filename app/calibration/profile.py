"""The calibration profile: the maps of one body in one shirt, as a versioned document."""

import math
from collections.abc import Sequence
from typing import Annotated, Any, Literal, Self

from pydantic import BeforeValidator, Field, PlainSerializer, model_validator

from app.calibration.linear_map import LinearMap, MapKind, Numbers
from app.layout import MAX_CHANNELS, MAX_JOINTS, ShirtLayout, is_missing
from app.quantities import Document, Finite, Fraction, Hertz, Name, Threshold
from app.stored_text import StoredText
from app.texts import Text, in_sequence, to_document

Grade = Literal["good", "usable", "repeat"]

Covariances = Annotated[
    tuple[Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-1e24, le=1e24)], ...],
    Field(max_length=MAX_CHANNELS),
]
Noise = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=1e12)]


def _sentences(stored: object) -> object:
    """Return sentences as a tuple: before, a profile had them as one string."""
    return (stored,) if isinstance(stored, str) else tuple(stored) if isinstance(stored, list) else stored


def _stored(sentences: tuple[Text | str, ...]) -> str | list[Any]:
    """Return sentences as they are stored; those of before as they were, so that the hash of a set stays."""
    documents = [to_document(sentence) for sentence in sentences]
    return documents[0] if len(documents) == 1 and isinstance(documents[0], str) else documents


Sentences = Annotated[tuple[StoredText, ...], BeforeValidator(_sentences), PlainSerializer(_stored)]


class JointMap(Document):
    """The maps of one joint, one of which decodes it.

    The score is the place on the axis of the PCA map, whichever map decodes:
    score = pca.rates[0] . (x[channels] - mean), in FS.
    """

    name: Name
    channels: Annotated[tuple[int, ...], Field(min_length=1, max_length=MAX_CHANNELS)]  # indices into a frame
    mean: Numbers  # one per entry of `channels`
    evr: Fraction  # explained variance ratio of PC1 in free movement
    prompted: bool  # whether prompts fixed which way the score rises; otherwise that is arbitrary
    angle_deg: Annotated[float, Field(ge=0, le=90)] | None = None  # between the free and the prompted PC1
    signal_to_noise: Annotated[float, Field(ge=0)] | None = None
    repeatability: Annotated[float, Field(ge=0)] | None = None  # spread of the repetitions' peaks / their mean
    rest_rate: Threshold  # FS/s, standard deviation of the rate at rest
    # FS: a larger change from one rest to another is no movement, within 0.02 s (a step) or 0.06 s (a filtered one).
    step: Threshold
    filtered_step: Threshold
    grade: Grade
    reason: Sentences  # for the grade, the worst first
    map: MapKind = "pca"  # the map that decodes
    pca: LinearMap  # of the main component of free movement
    guided: LinearMap | None = Field(default=None, exclude_if=is_missing)  # learnt from own prompts alone
    prior: LinearMap | None = Field(default=None, exclude_if=is_missing)  # learnt from other people
    # (k, k) of the channels' movement in the calibration, squared signal units: from it follows what a bad channel
    # would show, and how exactly that is known.
    covariance: Annotated[tuple[Covariances, ...], Field(max_length=MAX_CHANNELS)]

    @model_validator(mode="after")
    def _lengths_agree(self) -> Self:
        if len(self.channels) != len(self.mean):
            raise ValueError(Text("calibration-profile-means", joint=self.name))
        for kind, linear in (("pca", self.pca), ("guided", self.guided), ("prior", self.prior)):
            if linear is None:
                if self.map == kind:
                    raise ValueError(Text("calibration-profile-map", joint=self.name, map=kind))
            elif any(len(part) != len(self.channels) for part in linear.parts):
                raise ValueError(Text("calibration-profile-parts", joint=self.name, map=kind))
        if not any(self.pca.rates[0]):
            raise ValueError(Text("calibration-profile-pca", joint=self.name))
        self._check_covariance()
        return self

    def _check_covariance(self) -> None:
        count, covariance = len(self.channels), self.covariance
        if len(covariance) != count or any(len(row) != count for row in covariance):
            raise ValueError(Text("calibration-profile-covariance", joint=self.name, count=count))
        if any(covariance[i][j] != covariance[j][i] for i in range(count) for j in range(i)):
            raise ValueError(Text("calibration-profile-symmetric", joint=self.name))
        if any(covariance[i][i] < 0.0 for i in range(count)):
            raise ValueError(Text("calibration-profile-variance", joint=self.name))

    @property
    def span(self) -> float:
        """Signal units per FS: the extent of the full movement along the axis of the score."""
        return 1.0 / math.hypot(*self.pca.rates[0])

    @property
    def direction(self) -> tuple[float, ...]:
        """The axis of the score, of unit length, one number per channel; it points along the prompted movement."""
        span = self.span
        return tuple(weight * span for weight in self.pca.rates[0])

    def with_direction(self, direction: Sequence[float]) -> Self:
        """Return the joint with another axis of its score, of unit length, and the same span."""
        pca = self.pca.model_copy(update={"rates": (tuple(float(part) / self.span for part in direction),)})
        return self.model_copy(update={"pca": pca})

    @property
    def has_to_be_repeated(self) -> bool:
        """Whether the measurements say that the movement is too weak or too uneven to drive with."""
        return self.grade == "repeat"

    @property
    def description(self) -> Text:
        """What the measurements say about the movement, and what to do."""
        return in_sequence(self.reason)

    @property
    def advice(self) -> Text | None:
        """What the measurements advise to do; None when they are good."""
        return None if self.grade == "good" else self.description

    @property
    def linear(self) -> LinearMap:
        """The map that decodes."""
        return {"pca": None, "guided": self.guided, "prior": self.prior}[self.map] or self.pca

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
        """Dead-zone and full (FS/s) that the calibration suggests for the map that decodes."""
        return self.linear.dead_zone, self.linear.full


class CalibrationProfile(Document):
    """The saved result of a calibration; never changed, only succeeded by a newer version."""

    format: Literal["bodydrive-profile"] = "bodydrive-profile"
    version: Literal[1] = 1
    created: str  # UTC, ISO 8601
    software: str  # version of bodydrive that made it
    layout: ShirtLayout
    sample_rate: Hertz
    left_out: dict[str, StoredText]  # channel name -> why it is not in the map
    low: Numbers  # (n_channels,) smallest value in the calibration
    high: Numbers  # (n_channels,) largest value in the calibration
    # (n_channels,) standard deviation of each channel's noise in the calibration, signal units: a channel that shows
    # much less of it is stuck.
    noise: Annotated[tuple[Noise, ...], Field(max_length=MAX_CHANNELS)]
    joints: Annotated[tuple[JointMap, ...], Field(min_length=1, max_length=MAX_JOINTS)]
    cross_talk: tuple[tuple[Finite, ...], ...] | None = None
    """Row: joint that was prompted; column: joint that answered, as a share of its activation when prompted itself.

    1.0 on the diagonal; 0.0 where one of the two was never prompted (`JointMap.prompted`). None without prompts.
    """

    @model_validator(mode="after")
    def _channels_exist(self) -> Self:
        count = len(self.layout.channels)
        if not len(self.low) == len(self.high) == count:
            raise ValueError(Text("calibration-profile-range", count=count))
        if len(self.noise) != count:
            raise ValueError(Text("calibration-profile-noise", count=count))
        for joint in self.joints:
            if any(not 0 <= index < count for index in joint.channels):
                raise ValueError(Text("calibration-profile-channel", joint=joint.name))
        return self
