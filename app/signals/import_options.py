"""How a person corrects what an uploaded recording says of itself, as the page sends it."""

from typing import Annotated, Literal

from pydantic import Field

from app.layout import MAX_CHANNELS
from app.quantities import Document, Name
from app.signals.sampling_times import FASTEST, SLOWEST

ColumnName = Annotated[str, Field(max_length=500)]  # as the file has it
TimeUnit = Literal["s", "ms", "us", "ns", "min", "h", "d"]
SampleRate = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=SLOWEST, le=FASTEST)]  # Hz
JointName = Annotated[Name, Field(max_length=60)]  # the name of a channel is longer by its number


class ImportedChannel(Document):
    """A column that is a channel, and the joint that it is of."""

    column: ColumnName
    joint: JointName


class ImportOptions(Document):
    """What is corrected; None: as the file says."""

    part: ColumnName | None = None  # a stream, or a sheet, that is read alone
    time: ColumnName | None = None  # empty: no column is the time
    unit: TimeUnit | None = None
    rate: SampleRate | None = None
    channels: Annotated[list[ImportedChannel], Field(min_length=1, max_length=MAX_CHANNELS)] | None = None
