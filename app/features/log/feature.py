"""Reading the log, which the store writes: what the feature gives to the rest of the program."""

from typing import Final

from app.features.registration import Feature

FEATURE: Final = Feature(routes=("routes",))
