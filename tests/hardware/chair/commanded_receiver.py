"""A receiver and its sender on a simulated time, for tests."""

from app.hardware.chair.key import Key
from app.hardware.chair.packet import DRIVE, ChairCommand, decode_telemetry, encode_command
from app.hardware.chair.receiver import Receiver, ReceiverState

STEP, PERIOD = 0.01, 0.02  # s
KEY = Key(7, bytes(range(32)))
DIGEST = b"practise"


class CommandedReceiver:
    """A receiver that is stepped every 10 ms, and a sender for it."""

    def __init__(self, **options):
        self.nonces = 0
        self.receiver = Receiver(KEY, new_nonce=self._nonce, **options)
        self.t = 1000.0
        self.sender_ahead = -400.0  # s: two machines, two clocks
        self.epoch, self.sequence = 100, 0
        self.speeds = []  # (t, v, omega) of every step
        self.conditions = {}
        self.step()

    def _nonce(self, size):
        self.nonces += 1
        return self.nonces.to_bytes(size, "little")

    @property
    def state(self):
        return self.receiver.state

    @property
    def reason(self):
        return self.receiver.reason

    @property
    def told(self):
        return decode_telemetry(self.receiver.telemetry(self.t), KEY)

    def frame(self, v=0.0, omega=0.0, flags=0, key=KEY, nonce=None, **changes):
        """Return the next command's bytes; `changes` replace fields of it."""
        self.sequence += 1
        t_ns = int((self.t + self.sender_ahead) * 1e9)
        command = ChairCommand(flags, key.id, self.epoch, self.sequence, t_ns, v, omega, 1.5, 2.5, DIGEST)
        return encode_command(command._replace(**changes), key, self.receiver.nonce if nonce is None else nonce)

    def send(self, *words, **changes):
        return self.receiver.accept(self.frame(*words, **changes), self.t)

    def step(self, dt=STEP):
        self.t += dt
        v, omega = self.receiver.step(self.t, **self.conditions)
        self.speeds.append((self.t, v, omega))

    def wait(self, seconds):
        for _ in range(round(seconds / STEP)):
            self.step()

    def command(self, seconds, *words, **changes):
        """Send the same at 50 Hz for so long."""
        for _ in range(round(seconds / PERIOD)):
            self.send(*words, **changes)
            self.wait(PERIOD)

    def arm(self):
        self.epoch += 1
        self.command(0.56)
        assert self.state is ReceiverState.ARMED

    def drive(self, v=0.5, omega=0.0, seconds=0.6):
        self.arm()
        self.command(seconds, v, omega, DRIVE)
        return self
