"""The dead-zone and the full rate of a joint's gestures, as a calibration chooses them and as they may be adapted."""

from typing import Final

REST_NOISE_FACTOR: Final = 4.0  # the dead-zone over the noise of the rate at rest
SMALLEST_DEAD_ZONE: Final = 0.15  # FS/s
LARGEST_DEAD_ZONE: Final = 99.0  # FS/s
LEAST_RANGE: Final = 0.1  # FS/s between dead-zone and full: less would make the gesture a switch

# Shares of full.
LARGEST_GUIDED_SHARE: Final = 0.3  # movements much weaker than the prompted ones are still to drive
LARGEST_ADAPTED_SHARE: Final = 0.5  # of the calibration's full: half of the movement is left to drive with
LEAST_PRIOR_SHARE: Final = 0.05  # with fewer people's strokes than usual the quantile could lie below 0


def dead_zone_over(noise: float, least: float = 0.0) -> float:
    """Return the dead-zone (FS/s), at least `least`, for a noise of the rate at rest (FS/s)."""
    return round(min(max(REST_NOISE_FACTOR * noise, least, SMALLEST_DEAD_ZONE), LARGEST_DEAD_ZONE), 4)


def full_over(dead_zone: float, reached: float) -> float:
    """Return the rate (FS/s) that counts as full, for strokes that have reached the rate `reached` (FS/s)."""
    return round(min(max(reached, dead_zone + LEAST_RANGE), LARGEST_DEAD_ZONE + LEAST_RANGE), 4)
