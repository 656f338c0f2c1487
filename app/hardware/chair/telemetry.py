"""The newest telemetry of a real chair; recordings of earlier telemetry are rejected. No clock, no socket."""

import math
from typing import NamedTuple

from app.hardware.chair.link_texts import reason_text
from app.hardware.chair.packet import Telemetry
from app.texts import Figure, Text

SILENT = 0.3  # s without telemetry, which comes every 0.1 s
DRIFT = 1e-3  # s per s by which the chair's clock may differ from ours
MOST_NONCES = 1000  # number of nonces kept: a chair makes a new one at each disarming
ARMED, FAULT = 2, 3  # values of Telemetry.state
STATE_NAMES = ("disarmed", "checking", "armed", "fault")


class PressedSwitch(NamedTuple):
    """A telemetry that shows the stop switch pressed, and that may be a recording."""

    nonce: bytes
    t_ns: int  # of the chair's clock
    t: float  # monotonic s, when it came


class ChairTelemetry:
    """The newest telemetry of a chair.

    Somebody can record a telemetry and send it again: its tag is still right. It must roll back neither the nonce nor
    the state. So a telemetry is taken only when its chair time is later than that of every telemetry taken with the
    same nonce, and when one of these holds:

    - its nonce is that of the newest telemetry: the chair continues;
    - it carries the epoch of the current arming: nobody can have recorded it before the arming; within the epoch the
      chair's time must grow;
    - nothing was taken for `SILENT` seconds: the chair was started again, or this chair link was.

    A forger can still show an old telemetry in place of a silent chair. That arms nothing, because a chair counts as
    ready only when its telemetry carries the epoch of the current arming. Nor does it show a switch: a pressed one
    counts as seen in a telemetry that carries our epoch. One seen before the arming is confirmed by the first telemetry
    that carries it: by the same nonce, and a chair's time by which the switch was pressed when that report came, not
    earlier. Otherwise the chair does not become ready, and the switch has to be shown again.

    Attributes
    ----------
    newest : Telemetry or None
        The telemetry that was taken last.
    t : float
        When it arrived (monotonic s); -inf before the first.
    switch_seen : bool
        Whether the chair has shown its stop input pressed to us, so that it exists and works.
    switch_refuted : bool
        Whether what showed it pressed before the current arming was a recording, or of the chair's earlier start; an
        arming, which may make several epochs, begins with False.
    """

    def __init__(self) -> None:
        self.newest: Telemetry | None = None
        self.t = -math.inf
        self.switch_seen = False
        self.switch_refuted = False
        self._pressed: PressedSwitch | None = None
        self._epoch = 0
        self._epoch_ns = -1
        self._nonces: dict[bytes, int] = {}  # nonce: the chair's latest time (ns) with it

    def begin_epoch(self, epoch: int) -> None:
        """Expect the epoch (not 0) of a new arming in the telemetry."""
        self._epoch, self._epoch_ns = epoch, -1

    def accept(self, telemetry: Telemetry, t: float) -> bool:
        """Take a telemetry with a valid tag that arrived at `t` (monotonic s); False when it may be a recording."""
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
        self._update_switch(telemetry, t)
        return True

    def _update_switch(self, telemetry: Telemetry, t: float) -> None:
        if self.answers:
            if self._pressed is not None and not self.switch_seen:
                self.switch_seen = _shows_now(self._pressed, telemetry, t)
                self.switch_refuted = not self.switch_seen
            self._pressed = None
            self.switch_seen |= telemetry.stop_input != 0
        elif telemetry.stop_input:
            self._pressed = PressedSwitch(telemetry.nonce, telemetry.t_ns, t)

    @property
    def switch_reported(self) -> bool:
        """Whether the stop switch was seen, or a telemetry shows it that the next arming has to confirm."""
        return self.switch_seen or self._pressed is not None

    @property
    def answers(self) -> bool:
        """Whether the newest telemetry carries the epoch of the current arming."""
        return self.newest is not None and self._epoch != 0 and self.newest.epoch == self._epoch

    @property
    def ready(self) -> bool:
        """Whether the chair has accepted the current arming and obeys commands to move."""
        if self.newest is None or self.switch_refuted:
            return False
        return self.answers and self.newest.state == ARMED and not self.newest.stop_input

    @property
    def inhibited(self) -> bool:
        """Whether the chair's stop switch is pressed, or it has a fault."""
        return self.newest is not None and (self.newest.state == FAULT or self.newest.stop_input != 0)


def _shows_now(pressed: PressedSwitch, telemetry: Telemetry, t: float) -> bool:
    """Return whether a telemetry of our own epoch, come at `t`, shows that the pressed switch was no recording."""
    passed = t - pressed.t
    by_chair = 1e-9 * (telemetry.t_ns - pressed.t_ns)
    return pressed.nonce == telemetry.nonce and by_chair <= passed + SILENT + DRIFT * passed


def telemetry_description(name: str, place: str, telemetry: Telemetry) -> Text:
    """Return the state, the battery and the fault in a telemetry of the chair `name` at `place` (HOST:PORT)."""
    known = 0.0 <= telemetry.battery <= 1.0
    return Text(
        "chairdev-telemetry",
        name=name,
        place=place,
        state="stop-switch" if telemetry.stop_input else STATE_NAMES[min(telemetry.state, FAULT)],
        battery=Figure(100 * telemetry.battery) if known else "unknown",
        reason=reason_text(telemetry.fault) or "none",
    )
