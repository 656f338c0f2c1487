"""A person's estimate of the effect of a stroke, and its correction by observed effects."""

# Compiled in a wheel (hatch_build.py).

LOSS_SHARE = 0.005  # learning rate of the loss relative to that of the gain


class StrokeEstimate:
    """For one limb: effect = gain x (size - lost), with both numbers learnt from errors.

    The size is of the joint's range; the effect is in m/s for an elbow (speed gained or lost) and in rad for a shoulder
    (angle turned). `lost` is the part of a stroke inside the dead-zone.
    """

    __slots__ = ("gain", "lost")

    def __init__(self, gain: float, lost: float) -> None:
        self.gain = gain
        self.lost = lost

    def effect_of(self, size: float) -> float:
        """Return the expected effect of a stroke of `size`."""
        return self.gain * max(0.0, size - self.lost)

    def size_for(self, effect: float) -> float:
        """Return the size of a stroke with the expected `effect`."""
        return self.lost + effect / self.gain

    def learn(self, size: float, effect: float, correction: float) -> None:
        """Correct a share of the error of the last stroke (normalised least mean squares).

        Both numbers are bounded, so that one outlier (a wall, a stroke by the wrong limb) cannot ruin the estimate.
        """
        above = max(0.05, size - self.lost)
        error = effect - self.effect_of(size)
        weight = above * above + self.gain * self.gain * LOSS_SHARE
        self.gain = min(5.0, max(0.1, self.gain + correction * error * above / weight))
        self.lost = min(0.25, max(0.0, self.lost - correction * error * self.gain * LOSS_SHARE / weight))
