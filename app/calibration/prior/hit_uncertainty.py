"""The uncertainty of expected hits, which falls with each repetition of the person's own."""

import math

from app.calibration.linear_map import Forecast
from app.calibration.script import REPETITIONS

# Measured on the real knit with people kept apart: the deviation within which the hits of about two recordings of
# three came, without own repetitions, and how it falls with them (docs/learning/prior-measured.md).
FIRST_DEVIATION, FALL = 0.066, 0.8


def deviation_of_hits(repetitions: int) -> float:
    """Return the standard deviation of expected hits of 100 movements, with so many own repetitions."""
    return round(100 * FIRST_DEVIATION * math.pow(1 + repetitions, -FALL), 1)


def hits_with_prompts(without: Forecast) -> Forecast:
    """Return the hits of 100 movements to expect after a calibration's repetitions, from those without any.

    The number is the same, and its uncertainty smaller: repetitions brought more hits on neither garment
    (docs/learning/prior-measured.md).
    """
    return Forecast(value=without.value, uncertainty=deviation_of_hits(REPETITIONS))
