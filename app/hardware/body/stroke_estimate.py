"""What a person believes a stroke to do, and how that belief is corrected by what it did."""

LOSS_SHARE = 0.005  # how readily an error is put down to the loss rather than to the gain


class StrokeEstimate:
    """For one limb: effect = gain x (size - lost), with both numbers learnt from errors.

    The size is of the joint's range; the effect is in m/s for an elbow (speed gained or lost) and in rad for a shoulder
    (angle turned). `lost` stands for what the dead-zone takes away.
    """

    __slots__ = ("gain", "lost")

    def __init__(self, gain: float, lost: float) -> None:
        self.gain = gain
        self.lost = lost

    def effect_of(self, size: float) -> float:
        """Return the effect that is expected of a stroke of `size`."""
        return self.gain * max(0.0, size - self.lost)

    def size_for(self, effect: float) -> float:
        """Return the size that is believed to have `effect`."""
        return self.lost + effect / self.gain

    def learn(self, size: float, effect: float, correction: float) -> None:
        """Correct a share of the error of the last stroke (normalised least mean squares).

        Bounded, so that one freak (a wall, a stroke by the wrong limb) cannot turn the belief upside down.
        """
        above = max(0.05, size - self.lost)
        error = effect - self.effect_of(size)
        weight = above * above + self.gain * self.gain * LOSS_SHARE
        self.gain = min(5.0, max(0.1, self.gain + correction * error * above / weight))
        self.lost = min(0.25, max(0.0, self.lost - correction * error * self.gain * LOSS_SHARE / weight))
