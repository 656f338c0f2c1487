"""The forms in which recordings and measures leave the clinic."""

from typing import Final, Literal, get_args

Form = Literal["csv", "parquet", "xdf", "bids", "fhir"]
FORMS: Final[tuple[Form, ...]] = get_args(Form)
