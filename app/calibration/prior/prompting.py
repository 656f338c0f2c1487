"""What a person's own repetitions bring to a forecast of hits: it is surer with each of them."""

import math

from app.calibration.profile import Forecast
from app.calibration.script import REPETITIONS

# Standard deviations of the share of a stroke's time with activation, measured on the real knit: between what is
# expected from many repetitions and what comes, and what one repetition more or less makes.
LASTING_DEVIATION, FIRST_DEVIATION = 0.08, 0.12


def deviation_of_hits(repetitions: int) -> float:
    """Return the standard deviation of expected hits of 100 movements, with so many own repetitions."""
    return round(100 * math.sqrt(LASTING_DEVIATION**2 + FIRST_DEVIATION**2 / (1 + repetitions)), 1)


def hits_with_prompts(without: Forecast) -> Forecast:
    """Return the hits of 100 movements to expect after a calibration's repetitions, from those without any.

    They are as many, and surer: that repetitions also bring more hits was seen on neither garment
    (docs/learning/prior-measured.md).
    """
    return Forecast(value=without.value, uncertainty=deviation_of_hits(REPETITIONS))
