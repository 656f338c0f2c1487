"""Which frames of a device are lost, repeated or late: its frame counter, and its clock against ours. No socket."""

import math

WRAP = 1 << 32  # of frames, and of microseconds: a device that counts them in 32 bits begins anew after 72 minutes
BACKWARDS = 1 << 31  # a larger step ahead, modulo 2^32, is a step back
RESTART_AHEAD = 1 << 20  # frames: a larger step ahead is a restart of the device, not a loss
RESTART_AFTER = 10  # frames in a row that count up behind the newest: late frames do not, a restarted device does
LATE = 0.1  # s beyond the quickest frame, as a chair allows its commands: more is no jitter of a radio
FORGIVEN = 2e-4  # s per s by which the least delay is raised: two clocks of 100 ppm, one too fast and one too slow


class Sequence:
    """Counts lost, late and repeated frames by a u32 counter that wraps, and notices restarts of the device."""

    __slots__ = ("_behind", "_last", "_straggler", "dropped", "lost", "restarts")

    def __init__(self) -> None:
        self.lost = 0  # frames that never came
        self.dropped = 0  # frames that came twice or after a newer one
        self.restarts = 0
        self._last = -1  # -1: nothing yet
        self._behind = 0
        self._straggler = -1

    def forget(self) -> None:
        """Start from the next frame, which another device sends, or the device after a restart."""
        self._last = self._straggler = -1
        self._behind = 0

    def accept(self, seq: int) -> bool:
        """Return whether the frame of number `seq` is new; late and repeated frames are not."""
        ahead = (seq - self._last) % WRAP
        if ahead == 1 or self._last < 0:
            self._last = seq
            self._behind = 0
            return True
        if 0 < ahead < BACKWARDS:
            if ahead < RESTART_AHEAD:
                self.lost += ahead - 1
            else:
                self.restarts += 1
            self._last = seq
            self._behind = 0
            return True
        if ahead != 0 and self._is_restart(seq):
            self.restarts += 1
            self._last = seq
            self._behind = 0
            return True
        self.dropped += 1
        return False

    def _is_restart(self, seq: int) -> bool:
        """Return whether frames behind the newest have counted up for so long that the device must have restarted."""
        counts_up = self._behind and (seq - self._straggler) % WRAP == 1
        self._behind = self._behind + 1 if counts_up else 1
        self._straggler = seq
        return self._behind >= RESTART_AFTER


class Lateness:
    """Measures how late the frames of one device come, in the order in which they were sent.

    Whoever holds a network can keep genuine frames back and hand them on later: they are signed, new and in order, and
    the body that they show is one of the past. What the two clocks differ by is unknown, but it does not change: the
    frame that took least time shows it, and how much longer a later frame took is its lateness. A delay that is there
    from the first frame on cannot be seen in this way.
    """

    __slots__ = ("_forgiven", "_least", "_microseconds", "_t", "_wrapped")

    def __init__(self, forgiven: float = FORGIVEN) -> None:
        """`forgiven` (s per s) is how much the two clocks may differ in pace."""
        self._forgiven = forgiven
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
        self._least = min(self._least + self._forgiven * (t - self._t), delay)
        self._microseconds, self._t = microseconds, t
        late = delay - self._least
        return late if late > LATE else 0.0
