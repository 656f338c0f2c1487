"""The sender of a real chair: commands at 50 Hz to its receiver, telemetry back (docs/protocols.md, section 9).

It decides nothing about motion: what the gate permits is what it tells. It never waits.
"""

import itertools
import math
import secrets
import socket
from collections import deque
from pathlib import Path

from app.faults import State
from app.geometry import STANDSTILL, Pose, Twist
from app.hardware.base import ORIGIN, HardwareError
from app.hardware.chair.key import Key, KeyRefused, read_key
from app.hardware.chair.odometry import arc
from app.hardware.chair.packet import (
    DIGEST_BYTES,
    DRIVE,
    FRAME_BYTES,
    STOP,
    Command,
    Telemetry,
    decode_telemetry,
    encode_command,
    encode_hello,
)
from app.hardware.chair.reasons import WORDS, Reason
from app.hardware.chair.simulator import FASTEST, ChairState
from app.hardware.chair.telemetry import SILENT, ChairTelemetry
from app.hardware.configs import RealChairConfig
from app.speeds import Speeds

PERIOD = 0.02  # s between two commands
LEAST_GAP = 0.005  # s: after a hold-up the next deadline may be very near
STALLED = 0.15  # s without a command: the chair, which waits 0.1 s, has stopped, and is not to go on by itself (S15)
LAST_FRAMES = 10  # zero commands after disarming or a stop: any one of them suffices
HELLO_AFTER = 0.15  # s without telemetry, which comes every 0.1 s to whom the chair is paired with
HELLO_EVERY = 0.2  # s: a chair that is paired with another address is heard at 5 Hz, and so never counts as silent
MOST_DATAGRAMS = 32  # taken at once: whoever floods this port does not hold up the loop
SETTLE = 1.0  # s after which a chair that still says that it moves is no longer waited for
RUNNING = (State.CHECKING, State.ARMED)
STATE_WORDS = ("disarmed", "checking that it is told to stand", "armed", "inhibited")

_sequence = itertools.count(1)  # of this process: it grows on when a chair is opened again


class ChairLink:
    """A chair behind a receiver, with the verbs of a chair; x, y and heading are reckoned from what it says it drives.

    Attributes
    ----------
    digest : bytes
        The first 8 bytes of the SHA-256 of the parameter set, for the next arming.
    due : float
        When the next command is to be sent (monotonic s), inf when none is.
    """

    is_real = True

    def __init__(self, config: RealChairConfig) -> None:
        self.config = config
        self.speeds = config.speeds
        self.digest = bytes(DIGEST_BYTES)
        self.due = math.inf
        self.telemetry = ChairTelemetry()
        self._now = -math.inf
        self._key = Key(0, b"")
        self._socket: socket.socket | None = None
        self._state = State.DISARMED
        self._flags = 0
        self._left = 0  # zero commands still to be sent after the last arming
        self._ended = -math.inf
        self._epoch = 0  # 0: none yet
        self._nonce = b""  # for which the epoch was begun
        self._armed_digest = self.digest
        self._sent: deque[tuple[int, float]] = deque(maxlen=100)  # sequence, when
        self._sent_at = -math.inf
        self._stalled = False  # since the arming no command was sent for too long
        self._echoed = -math.inf  # when the newest command was sent of which the chair has told that it has it
        self._hello_due = -math.inf
        self.place(ORIGIN)

    def open(self) -> None:
        """Read the key and open the way to the chair.

        Raises
        ------
        HardwareError
            In one sentence, when the key file is not one or the host is not known; nothing is held then.
        """
        self.close()
        host, port = self.config.host, self.config.port
        try:
            self._key = read_key(Path(self.config.key_file))
        except KeyRefused as error:
            raise HardwareError(f"the chair {self.config.name} is not opened: {error}") from error
        opened = None
        try:
            family, kind, protocol, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM)[0]
            opened = socket.socket(family, kind, protocol)
            opened.setblocking(False)
            opened.connect(address)  # from now on the kernel drops what others send
        except (OSError, UnicodeError) as error:
            if opened is not None:
                opened.close()
            raise HardwareError(
                f"the chair {self.config.name} cannot be reached at {host}:{port} "
                f"({getattr(error, 'strerror', None) or 'no host name'}): correct its address"
            ) from error
        self._socket = opened

    def close(self) -> None:
        """Give the socket back; closing twice does no harm."""
        if self._socket is not None:
            self._socket.close()
            self._socket = None

    def place(self, pose: Pose) -> None:
        """Begin to reckon at `pose`."""
        self._pose = pose
        self.state = ChairState(*pose, 0.0, 0.0, in_contact=False, contacts=0)

    def drive(self, _twist: Twist, dt: float, _permitted: bool = False) -> ChairState:
        """Reckon on by `dt` (s) and return the new state; `tell` is what tells the chair to drive."""
        driven = self._driven()
        self._pose = pose = arc(self._pose, driven, dt)
        self.state = ChairState(*pose, *driven, in_contact=False, contacts=0)
        return self.state

    def listen(self, t: float) -> None:
        """Take what has come up to `t` (monotonic s), and ask for telemetry when none comes."""
        self._now = t
        self._stalled |= self._state is State.ARMED and t - self._sent_at > STALLED
        for _ in range(MOST_DATAGRAMS):
            datagram = self._received()
            if datagram is None:
                break
            telemetry = decode_telemetry(datagram, self._key)
            if telemetry is not None and self.telemetry.take(telemetry, t):
                self._note_echo(telemetry)
        if t - self.telemetry.t > HELLO_AFTER and t >= self._hello_due:
            self._hello_due = t + HELLO_EVERY
            self._put(encode_hello(self._key.id))

    def tell(self, state: State, twist: Twist, limits: Speeds, t: float) -> None:
        """Tell the chair, when it is time to or the gate's `state` has changed, to do `twist` within `limits`.

        Only while armed the twist is told; otherwise zeros are.
        """
        if state is not self._state:
            self._follow(state, t)
        if state is State.CHECKING and self.telemetry.newest is not None and self.telemetry.newest.nonce != self._nonce:
            # A chair that disarmed meanwhile has a new nonce, and takes no epoch twice.
            self._begin_epoch(self.telemetry.newest.nonce)
        if t >= self.due:
            self._send(twist, limits, t)

    def age(self, t: float) -> float:
        """Return how old (s) at `t` is what is known of the chair; inf when nothing is.

        While it drives, that is since the newest command was sent of which it has told that it has it: commands that
        take long to reach the chair are as bad as none.
        """
        age = t - self.telemetry.t
        return max(age, t - self._echoed) if self._state is State.ARMED and self.telemetry.ready else age

    @property
    def ready(self) -> bool:
        """Whether the chair has accepted this arming, moves when told, and has been told without a pause."""
        return self.telemetry.ready and not self._stalled

    @property
    def silent(self) -> bool:
        """Whether the chair has not been heard for too long."""
        return not self._now - self.telemetry.t <= SILENT  # before anything was listened for, that is no number

    @property
    def stands(self) -> bool:
        """Whether the chair was told to stand, and says that it does; one that goes on saying otherwise is left."""
        if self._state in RUNNING:
            return False
        return self._driven() == STANDSTILL or self._now - self._ended > SETTLE

    def words(self) -> str:
        """Return the chair's state in words."""
        chair = f"{self.config.name} at {self.config.host}:{self.config.port}"
        newest = self.telemetry.newest
        if newest is None or self.silent:
            return f"{chair} does not answer: check its power and the network."
        words = f"{chair}, {'stop switch pressed' if newest.stop_input else STATE_WORDS[min(newest.state, 3)]}"
        if 0.0 <= newest.battery <= 1.0:
            words += f", battery {newest.battery:.0%}"
        why = Reason(newest.fault) if newest.fault in WORDS else Reason.NONE
        return f"{words}." if why is Reason.NONE else f"{words}. {WORDS[why]}"

    def _driven(self) -> Twist:
        """Return how the chair says that it drives; one that is not heard stands by itself."""
        newest = self.telemetry.newest
        if newest is None or self.silent:
            return STANDSTILL
        v, omega = newest.v, newest.omega
        return Twist(v, omega) if abs(v) <= FASTEST and abs(omega) <= FASTEST else STANDSTILL

    def _follow(self, state: State, t: float) -> None:
        before, self._state = self._state, state
        if state is State.CHECKING:
            self._flags = self._left = 0
            self._armed_digest = self.digest
            self._nonce = b""
            self._stalled = False
            self.due = t
        elif state is State.FAULT or (state is State.DISARMED and before in RUNNING):
            self._ended = t
            self._flags = STOP if state is State.FAULT else 0
            self._left = LAST_FRAMES
            self.due = t

    def _begin_epoch(self, nonce: bytes) -> None:
        last, self._nonce = self._epoch, nonce
        while self._epoch in (0, last):
            self._epoch = secrets.randbits(32)
        self.telemetry.begin_epoch(self._epoch)
        self._sent.clear()

    def _send(self, twist: Twist, limits: Speeds, t: float) -> None:
        # Deadlines are absolute; those that were missed are left out.
        self.due += PERIOD * ((t - self.due) // PERIOD)
        while self.due < t + LEAST_GAP:
            self.due += PERIOD
        armed = self._state is State.ARMED
        if self._state not in RUNNING:
            self._left -= 1
            if self._left <= 0:
                self.due = math.inf
        newest = self.telemetry.newest
        if newest is None or not self._epoch:
            return
        v, omega = twist if armed else STANDSTILL
        command = Command(
            flags=DRIVE if armed else self._flags,
            key_id=self._key.id,
            epoch=self._epoch,
            sequence=next(_sequence),
            t_ns=int(t * 1e9),
            v=v,
            omega=omega,
            v_cap=max(limits.forward, limits.reverse),
            omega_cap=limits.turn,
            digest=self._armed_digest,
        )
        self._put(encode_command(command, self._key, newest.nonce))
        self._sent.append((command.sequence, t))
        self._sent_at = t

    def _note_echo(self, telemetry: Telemetry) -> None:
        if self.telemetry.answers:
            while self._sent and self._sent[0][0] <= telemetry.sequence:
                self._echoed = self._sent.popleft()[1]

    def _received(self) -> bytes | None:
        """Return a datagram, None when there is no other; one byte more than a frame shows what is too long."""
        if self._socket is not None:
            try:
                return self._socket.recv(FRAME_BYTES + 1)
            except BlockingIOError:
                return None
            except OSError:
                return b""  # nobody listened there for what was sent before
        return None

    def _put(self, datagram: bytes) -> None:
        for _ in range(2):  # the first attempt may only tell that nobody listened to the datagram before
            try:
                if self._socket is not None:
                    self._socket.send(datagram)
            except ConnectionRefusedError:
                continue
            except OSError:
                pass  # no room, no network: the next one is newer
            return
