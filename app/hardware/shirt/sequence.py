"""The frame counter of a device: counts lost, late and repeated frames, and notices restarts of the device."""

WRAP = 1 << 32
BACKWARDS = 1 << 31  # a larger step ahead, modulo 2^32, is a step back
RESTART_AHEAD = 1 << 20  # frames: a larger step ahead is a restart of the device, not a loss
RESTART_AFTER = 10  # frames in a row that count up behind the newest: late frames do not, a restarted device does


class Sequence:
    """Counts lost frames of a u32 counter that wraps."""

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
