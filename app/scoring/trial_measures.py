"""The document of a trial's measures, as `app.scoring.task_measures` writes it; what comes from elsewhere must fit."""

from typing import Annotated, Final, Self

from pydantic import ConfigDict, Field, StrictBool, model_validator

from app.quantities import Document, Finite, Name, Title
from app.scoring.measures import CIRCUMSTANCES, INTERRUPTIONS, TRIAL_MEASURES
from app.texts import Text

NUMBERS: Final = frozenset({*TRIAL_MEASURES, *INTERRUPTIONS, *CIRCUMSTANCES})
MOST_PARTS: Final = 100  # of a course

Figure = Finite | StrictBool | None


class PartMeasures(Document):
    """The measures of a trial, or of one stage of a course: a number for each name, None where it has no value."""

    model_config = ConfigDict(extra="allow", frozen=True, allow_inf_nan=False)
    __pydantic_extra__: dict[Name, Figure] = Field(init=False)

    reached: StrictBool | None = None
    title: Title | None = None  # of a stage
    kind: Name | None = None  # of a stage's task

    @model_validator(mode="after")
    def _numbers(self) -> Self:
        for name, value in self.__pydantic_extra__.items():
            if name in NUMBERS and isinstance(value, bool):
                raise ValueError(Text("measure-no-number", name=name))
        return self


class TrialMeasures(PartMeasures):
    """The measures of a trial; those of a course have a part for each stage."""

    parts: Annotated[tuple[PartMeasures, ...], Field(max_length=MOST_PARTS)] = ()
