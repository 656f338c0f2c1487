"""How late a frame comes: a device's own clock against ours. No clock, no socket.

Whoever holds a network can keep genuine frames back and hand them on later: they are signed, new and in order, and the
body that they show is one of the past. What the two clocks differ by is unknown, but it does not change: the frame that
took least time shows it, and how much longer a later frame took is its lateness. A delay that is there from the first
frame on cannot be seen in this way.
"""

import math

LATE = 0.1  # s beyond the quickest frame, as a chair allows its commands: more is no jitter of a radio
FORGIVEN = 2e-4  # s per s by which the least delay is raised: two clocks of 100 ppm, one too fast and one too slow
WRAP = 1 << 32  # microseconds: a device that counts them in 32 bits begins anew after 72 minutes


class Lateness:
    """Measures how late the frames of one device come, in the order in which they were sent."""

    __slots__ = ("_least", "_microseconds", "_t", "_wrapped")

    def __init__(self) -> None:
        self.forget()

    def forget(self) -> None:
        """Begin with the next frame: another device sends it, or the device after a restart."""
        self._least = math.inf  # s, the least difference between our clock and the device's
        self._microseconds = -1  # device time of the newest frame
        self._wrapped = 0  # microseconds that the device's counter has lost by wrapping
        self._t = 0.0  # monotonic s, when the newest frame came

    def of(self, microseconds: int, t: float) -> float:
        """Return by how much (s) a frame of this device time that came at `t` (monotonic s) is late; 0: it is not.

        A clock that stands shows no lateness. One that is set back makes its frames late until the device is started
        again.
        """
        if microseconds == self._microseconds:
            return 0.0
        if self._microseconds < WRAP and self._microseconds - microseconds > WRAP // 2:
            self._wrapped += WRAP
        delay = t - 1e-6 * (microseconds + self._wrapped)
        self._least = min(self._least + FORGIVEN * (t - self._t), delay)
        self._microseconds, self._t = microseconds, t
        late = delay - self._least
        return late if late > LATE else 0.0
