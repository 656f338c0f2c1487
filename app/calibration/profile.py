"""The calibration profile: what was learnt of this body in this shirt, as a versioned document."""

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from app.layout import MAX_CHANNELS, MAX_JOINTS, ShirtLayout
from app.quantities import Document, Finite, Fraction, Hertz, Name, Threshold

Grade = Literal["good", "usable", "repeat"]

Numbers = Annotated[tuple[Finite, ...], Field(max_length=MAX_CHANNELS)]
Span = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, le=1e12)]


class JointMap(Document):
    """How one joint's channels become one score: sign * weights . (x[channels] - mean) / span."""

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
    grade: Grade
    reason: str

    @model_validator(mode="after")
    def _lengths_agree(self) -> Self:
        if not len(self.channels) == len(self.weights) == len(self.mean):
            raise ValueError(f"joint '{self.name}': channels, weights and mean must be of one length")
        return self


class CalibrationProfile(Document):
    """Saved once, never changed, only succeeded by a newer version."""

    format: Literal["bodydrive-profile"] = "bodydrive-profile"
    version: Literal[1] = 1
    created: str  # UTC, ISO 8601
    software: str  # version of bodydrive that made it
    layout: ShirtLayout
    sample_rate: Hertz
    left_out: dict[str, str]  # channel name -> why it is not in the map
    low: Numbers  # (n_channels,) smallest value seen in the calibration
    high: Numbers  # (n_channels,) largest
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
        for joint in self.joints:
            if any(not 0 <= index < count for index in joint.channels):
                raise ValueError(f"joint '{joint.name}' reads a channel that the layout does not have")
        return self
