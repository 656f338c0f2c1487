"""The forms in which recordings and measures leave the clinic."""

from typing import Literal

Form = Literal["csv", "parquet", "xdf", "bids", "fhir"]
FORMS: tuple[Form, ...] = ("csv", "parquet", "xdf", "bids", "fhir")
