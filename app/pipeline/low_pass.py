"""The low-pass filter of the loop, sample by sample in plain floats."""

from app.butterworth import Coefficients


class LowPass:
    """Second-order section in transposed direct form II, the form of scipy.signal.lfilter.

    The first sample settles the filter: the output is that sample, as after a constant input.
    """

    __slots__ = ("_a1", "_a2", "_b0", "_b1", "_b2", "_settled", "_z1", "_z2")

    def __init__(self, coefficients: Coefficients) -> None:
        self._b0, self._b1, self._b2, self._a1, self._a2 = coefficients
        self.reset()

    def reset(self) -> None:
        """Reset the state; the next sample settles the filter."""
        self._settled = False
        self._z1 = self._z2 = 0.0

    def step(self, sample: float) -> float:
        """Return the smoothed signal after `sample`."""
        if not self._settled:
            self._settled = True
            self._z1 = (1.0 - self._b0) * sample
            self._z2 = (self._b2 - self._a2) * sample
        smoothed = self._b0 * sample + self._z1
        self._z1 = self._b1 * sample - self._a1 * smoothed + self._z2
        self._z2 = self._b2 * sample - self._a2 * smoothed
        return smoothed
