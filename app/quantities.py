"""Strict, finite and bounded number types, and text types without invisible characters, for all input of people.

A plain pydantic `float` accepts NaN, Infinity, 1e999, `true` and `"3"`; these types do not. A plain `str` accepts
invisible characters, which change how other text looks; these types do not.
"""

from typing import Annotated

from pydantic import AfterValidator, BaseModel, ConfigDict, Field

from app.visible_text import visible_line, visible_lines

LOWEST_CUTOFF, HIGHEST_CUTOFF = 1, 8  # Hz
LARGEST_THRESHOLD = 100  # FS/s or FS

Metres = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-1000, le=1000)]
Length = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, le=1000)]  # m
Radians = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-6.2832, le=6.2832)]
Seconds = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=86_400)]
Hertz = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, le=5000)]
Cutoff = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=LOWEST_CUTOFF, le=HIGHEST_CUTOFF)]  # Hz
Threshold = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=LARGEST_THRESHOLD)]  # FS/s or FS
Fraction = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=1)]
Points = Annotated[int, Field(strict=True, ge=0, le=100)]  # of a slider
Finite = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-1e12, le=1e12)]
Count = Annotated[int, Field(strict=True, ge=0, le=2**31)]
Port = Annotated[int, Field(strict=True, ge=0, le=65_535)]
Line = Annotated[str, AfterValidator(visible_line)]  # its length is bounded where it is used
Note = Annotated[str, AfterValidator(visible_lines)]
Name = Annotated[str, Field(min_length=1, max_length=64, pattern=r"^[A-Za-z0-9][A-Za-z0-9_.-]*$")]
Title = Annotated[Line, Field(min_length=1, max_length=80)]


class Document(BaseModel):
    """Base of the models of input from browsers, files and the environment: no unknown fields, immutable."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)
