"""The receiver's loop: checks the time limits every 10 ms, whatever comes in. Standard library only."""

import math
import select
import socket

from app.clock import Clock
from app.hardware.chair.inputs import Inputs
from app.hardware.chair.outputs import Output
from app.hardware.chair.packet import FRAME_BYTES
from app.hardware.chair.reasons import DESCRIPTIONS, Reason
from app.hardware.chair.receiver import Receiver
from app.hardware.chair.telemetry_sender import TelemetrySender

STEP = 0.01  # s between two checks of the limits; the shortest limit of safety.md is 100 ms
LEAST = 0.001  # s to listen, also after a hold-up
DRAINING = 0.005  # s of a step for other datagrams than commands: leaves time to other programs in a flood
ENDING_LIMIT = 0.5  # s for the ramp to standstill at the end
PROBE_STEPS = 50  # number of steps whose lateness is measured at the start
PROBE_LIMIT = 0.01  # s of lateness, with which the limit of 100 ms becomes 110 ms


class ReceiverLoop:
    """Turns in steps until `ending`.

    Attributes
    ----------
    ending : bool
        Set to end the loop, also by a signal handler.
    """

    def __init__(
        self,
        receiver: Receiver,
        telemetry: TelemetrySender,
        end: socket.socket,
        output: Output,
        inputs: Inputs,
        clock: Clock,
    ) -> None:
        """`end` is a bound, non-blocking socket."""
        self._receiver = receiver
        self._telemetry = telemetry
        self._socket = end
        self._output = output
        self._inputs = inputs
        self._clock = clock
        self._output_broken = False
        self._stepped = -math.inf  # s
        self.ending = False

    def run(self) -> None:
        """Turn until `ending`, then bring the chair to standstill and send a last telemetry."""
        due = self._clock.now()
        while not self.ending:
            due = max(due + STEP, self._clock.now() + LEAST)
            # Act on silence when its limit is reached, not a step later, also when that was during a step.
            while (look := self._receiver.next_look(self._stepped)) < due:
                self._listen(look)
                self._step()
            self._listen(due)
            self._step()
        self._receiver.stop(Reason.ENDING)
        until = self._clock.now() + ENDING_LIMIT
        while any(self._receiver.driven) and self._clock.now() < until:
            due += STEP
            self._clock.sleep_until(due)
            self._step()
        self._step(last=True)

    def _listen(self, due: float) -> None:
        """Take datagrams until `due` (s); commands take effect at once."""
        enough = math.inf
        while (t := self._clock.now()) < due:
            if t >= enough:
                self._clock.sleep_until(due)
                return
            try:
                datagram, address = self._socket.recvfrom(FRAME_BYTES + 1)  # one byte more shows what is too long
            except OSError:  # no datagram; or an earlier telemetry found no listener, which does not matter
                select.select([self._socket], [], [], due - t)
                continue
            if self._receiver.accept(datagram, t):
                self._telemetry.set_driver(address)
                self._step()
            else:
                self._telemetry.answer_hello(datagram, address, t)
                enough = min(enough, t + DRAINING)

    def _step(self, last: bool = False) -> None:
        t = self._stepped = self._clock.now()
        pressed = self._inputs.stop_pressed
        twist = self._receiver.step(t, stop_pressed=pressed, output_broken=self._output_broken)
        state, reason = self._receiver.state, self._receiver.reason
        try:
            self._output.drive(t, state.name.lower(), twist, "" if reason is Reason.NONE else DESCRIPTIONS[reason])
            self._output_broken = False
        except OSError:
            self._output_broken = True
            if not self._output.is_real:
                self.ending = True  # the reader has gone
        self._telemetry.send(t, self._inputs, pressed, now=last)


def slowness(clock: Clock) -> list[str]:
    """Measure for half a second whether this machine keeps the steps; return a warning when it does not."""
    due, worst = clock.now(), 0.0
    for _ in range(PROBE_STEPS):
        due += STEP
        clock.sleep_until(due)
        worst = max(worst, clock.now() - due)
    if worst <= PROBE_LIMIT:
        return []
    return [
        f"This machine was {1e3 * worst:.0f} ms late in half a second of waiting: the chair may stop by as much later "
        "than the 110 and 310 ms that are promised. End other programs before anybody drives."
    ]
