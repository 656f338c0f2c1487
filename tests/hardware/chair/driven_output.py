"""An output behind a receiver and its loop, on a simulated time."""

from fake_clock import FakeClock
from hardware.chair.commanded_receiver import KEY, PERIOD, STEP, CommandedReceiver

from app.hardware.chair.inputs import Inputs
from app.hardware.chair.packet import DRIVE
from app.hardware.chair.receive import ReceiverLoop
from app.hardware.chair.receiver import ReceiverState
from app.hardware.chair.telemetry_sender import TelemetrySender


class DrivenOutput:
    """A sender at 50 Hz, a receiver, and the loop's steps every 10 ms."""

    def __init__(self, output):
        self.output = output
        self.chair = CommandedReceiver(v_max=output.most.v, omega_max=output.most.omega)
        self.clock = FakeClock(self.chair.t)
        sender = TelemetrySender(self.chair.receiver, KEY.id, self, None)
        self.loop = ReceiverLoop(self.chair.receiver, sender, self, output, Inputs(None, None), self.clock)

    @property
    def t(self):
        return self.clock.time

    @property
    def state(self):
        return self.chair.state

    @property
    def reason(self):
        return self.chair.reason

    def run(self, seconds, *words):
        """Send a command 50 times a second, or none, and step every 10 ms."""
        for number in range(round(seconds / STEP)):
            self.clock.time += STEP
            self.chair.t = self.clock.time
            if words and number % round(PERIOD / STEP) == 0:
                self.chair.send(*words)
            self.loop._step()

    def until(self, condition, seconds, *words):
        """Run until a condition holds, and return how long that took; fail after `seconds`."""
        begun = self.t
        while not condition():
            assert self.t - begun < seconds, "it did not come to that in time"
            self.run(PERIOD, *words)
        return self.t - begun

    def arm(self):
        self.chair.epoch += 1
        self.run(0.7, 0.0, 0.0)
        assert self.state is ReceiverState.ARMED

    def drive(self, v=0.2, omega=0.1, seconds=0.5):
        """Arm, and drive for some time."""
        self.run(0.1)
        self.arm()
        self.run(seconds, v, omega, DRIVE)
        assert self.state is ReceiverState.ARMED
        return self
