"""What a real chair said of itself, and which of it can be believed. No clock, no socket."""

import math

from app.hardware.chair.packet import Telemetry

SILENT = 0.3  # s without telemetry, which comes every 0.1 s
MOST_NONCES = 1000  # that are remembered: a chair makes one at each disarming
ARMED, FAULT = 2, 3  # states of a telemetry


class Heard:
    """The newest telemetry of a chair.

    A recording of telemetry has a true tag, too, and must roll back neither the nonce nor the state. So a telemetry is
    taken only when the chair's time in it is later than in all that was taken with its nonce, and when

    - its nonce is the one in force: the chair goes on; or
    - it tells the epoch of this arming: nobody can have recorded that before the arming, and within the epoch the
      chair's time must grow; or
    - nothing was taken for `SILENT` seconds: the chair was started anew, or this link was.

    What is left to a forger: to show an old picture of a chair that is silent. It arms nothing, because a chair
    counts as ready only when it tells the epoch of this arming.

    Attributes
    ----------
    newest : Telemetry or None
        What was taken last.
    t : float
        When that was (monotonic s); -inf when nothing has been heard.
    switch_seen : bool
        Whether the stop input was seen pressed: there is one, and it works.
    """

    def __init__(self) -> None:
        self.newest: Telemetry | None = None
        self.t = -math.inf
        self.switch_seen = False
        self._epoch = 0
        self._epoch_ns = -1
        self._nonces: dict[bytes, int] = {}  # nonce: the chair's latest time (ns) with it

    def begin_epoch(self, epoch: int) -> None:
        """Expect a new arming's epoch, not 0, in what the chair tells."""
        self._epoch, self._epoch_ns = epoch, -1

    def take(self, telemetry: Telemetry, t: float) -> bool:
        """Take a telemetry whose tag is right, heard at `t` (monotonic s); return False when it may be a recording."""
        if telemetry.t_ns <= self._nonces.get(telemetry.nonce, -1):
            return False
        if self._epoch and telemetry.epoch == self._epoch:
            if telemetry.t_ns <= self._epoch_ns:
                return False
            self._epoch_ns = telemetry.t_ns
        elif self.newest is not None and telemetry.nonce != self.newest.nonce and t - self.t <= SILENT:
            return False
        self._nonces[telemetry.nonce] = telemetry.t_ns
        if len(self._nonces) > MOST_NONCES:
            del self._nonces[next(iter(self._nonces))]
        self.newest, self.t = telemetry, t
        self.switch_seen |= telemetry.stop_input != 0
        return True

    @property
    def answers(self) -> bool:
        """Whether the newest telemetry tells the epoch of this arming."""
        return self.newest is not None and self._epoch != 0 and self.newest.epoch == self._epoch

    @property
    def ready(self) -> bool:
        """Whether the chair has accepted this arming, and moves when told."""
        return self.newest is not None and self.answers and self.newest.state == ARMED and not self.newest.stop_input

    @property
    def inhibited(self) -> bool:
        """Whether the chair's stop switch is pressed, or it has a fault."""
        return self.newest is not None and (self.newest.state == FAULT or self.newest.stop_input != 0)
