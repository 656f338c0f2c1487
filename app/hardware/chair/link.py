"""The link to a real chair: commands at 50 Hz to its receiver, telemetry back (docs/protocols.md, section 9).

The link decides nothing about motion: it sends what the gate permits. It never waits.
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
from app.hardware.chair.link_texts import lost_key, refusal_text
from app.hardware.chair.odometry import arc
from app.hardware.chair.packet import (
    DIGEST_BYTES,
    DRIVE,
    STOP,
    TELEMETRY_BYTES,
    ChairCommand,
    Telemetry,
    decode_telemetry,
    encode_command,
    encode_hello,
)
from app.hardware.chair.simulator import FASTEST
from app.hardware.chair.telemetry import SILENT, ChairTelemetry, telemetry_description
from app.hardware.configs import RealChairConfig
from app.messages import ChairState, Tick
from app.speed_limits import Speeds
from app.texts import Text

PERIOD = 0.02  # s between two commands
LEAST_GAP = 0.005  # s between two commands: after a hold-up the next deadline may be very near
POLL_PERIOD = 0.01  # s between two readings of the socket, half of the loop's longest wait for a frame
STALLED = 0.15  # s without a command: the chair, which waits 0.1 s, has stopped and must not resume by itself (S15)
LAST_FRAMES = 10  # zero commands sent after disarming or a stop; the chair needs one of them
HELLO_AFTER = 0.15  # s without telemetry, which a chair sends every 0.1 s to its paired address
HELLO_EVERY = 0.2  # s: a chair that is paired with another address then answers at 5 Hz and never counts as silent
MOST_DATAGRAMS = 32  # read at once, so that a flood of this port does not hold up the loop
SETTLE = 1.0  # s after which a chair that still reports motion counts as standing
STANDING = 0.02  # m/s and rad/s: a chair that measures its speed seldom measures 0
RUNNING = (State.CHECKING, State.ARMED)

_sequence = itertools.count(1)  # of this process: it continues when a chair is opened again


class ChairLink:
    """A chair behind a receiver; x, y and heading are integrated from the speeds in its telemetry."""

    def __init__(self, config: RealChairConfig) -> None:
        self.config = config
        self.speeds = config.speeds
        self.due = math.inf
        self.telemetry = ChairTelemetry()
        self._now = -math.inf
        self._key = Key(0, b"")
        self._socket: socket.socket | None = None
        self._state = State.DISARMED
        self._flags = self._left = 0  # flags of zero commands; how many are still to be sent after the last arming
        self._ended = -math.inf
        self._epoch, self._nonce = 0, b""  # of the current arming, and the nonce for which it was made; 0: none yet
        self._digest = self._armed_digest = bytes(DIGEST_BYTES)  # of the parameters: now, and when it was armed
        self._armed_document = bytes(DIGEST_BYTES)  # that the chair told of when it was armed; zeros: none
        self._twist = STANDSTILL  # of the newest `drive`
        self._sent: deque[tuple[int, float]] = deque(maxlen=100)  # sequence, when
        self._sent_at = -math.inf
        self._stalled = False  # whether no command was sent for too long since the arming
        self._echoed = -math.inf  # when the newest command was sent that the chair has acknowledged
        self._hello_due = -math.inf
        self.place(ORIGIN)

    def open(self) -> None:
        """Read the key and open the socket to the chair.

        Raises
        ------
        HardwareError
            In one sentence, when the key file is invalid or the host is unknown; no socket stays open then.
        """
        self.close()
        host, port = self.config.host, self.config.port
        try:
            self._key = read_key(Path(self.config.key_file))
        except KeyRefused as refused:
            problem = refusal_text(refused)
            raise HardwareError(Text("chairdev-not-opened", name=self.config.name, problem=problem)) from refused
        opened = None
        try:
            family, kind, protocol, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM)[0]
            opened = socket.socket(family, kind, protocol)
            opened.setblocking(False)
            opened.connect(address)  # from now on the kernel drops datagrams from other addresses
        except (OSError, UnicodeError) as error:
            if opened is not None:
                opened.close()
            why = getattr(error, "strerror", None) or "no-address"
            raise HardwareError(
                Text("chairdev-not-reached", name=self.config.name, place=f"{host}:{port}", why=why)
            ) from error
        self._socket = opened

    def close(self) -> None:
        """Close the socket; closing twice does no harm."""
        if self._socket is not None:
            self._socket.close()
            self._socket = None

    def place(self, pose: Pose) -> None:
        """Continue the integration from `pose`."""
        self._pose = pose
        self.state = ChairState(*pose, 0.0, 0.0, in_contact=False, contacts=0)

    def use_parameters(self, digest: bytes) -> None:
        """Name the parameter set of the next arming by the first 8 bytes of its SHA-256."""
        self._digest = digest

    def longest_wait(self, deadline: float, t: float) -> float:
        """Return how long (s) after `t` the loop may wait: at most until its `deadline` or until a command is due."""
        left = max(0.0, min(deadline, self.due) - t)
        return left if left <= POLL_PERIOD else left / 2

    def drive(self, twist: Twist, dt: float, _permitted: bool = False) -> ChairState:
        """Take `twist` as the next command, and integrate the reported speeds over `dt` (s) to the new state."""
        self._twist = twist
        driven = self._driven()
        self._pose = pose = arc(self._pose, driven, dt)
        self.state = ChairState(*pose, *driven, in_contact=False, contacts=0)
        return self.state

    def listen(self, t: float) -> None:
        """Take in the telemetry up to `t` (monotonic s); when none comes, send a hello, which asks for it."""
        self._now = t
        self._stalled |= self._state is State.ARMED and t - self._sent_at > STALLED
        for _ in range(MOST_DATAGRAMS):
            datagram = self._received()
            if datagram is None:
                break
            telemetry = decode_telemetry(datagram, self._key)
            if telemetry is not None and self.telemetry.accept(telemetry, t):
                self._update_echo(telemetry)
        if t - self.telemetry.t > HELLO_AFTER and t >= self._hello_due:
            self._hello_due = t + HELLO_EVERY
            self._put(encode_hello(self._key.id))

    def send(self, state: State, limits: Speeds, t: float) -> None:
        """Send the twist of the newest `drive`, when a command is due or the gate's `state` has changed.

        Unless `state` is ARMED, zeros are sent in its place.
        """
        if state is not self._state:
            self._follow(state, t)
        if state is State.CHECKING and self.telemetry.newest is not None and self.telemetry.newest.nonce != self._nonce:
            # A chair that disarmed since has a new nonce, and accepts no epoch twice.
            self._begin_epoch(self.telemetry.newest.nonce)
        if t >= self.due:
            self._send(limits, t)

    def age(self, t: float) -> float:
        """Return how old (s) at `t` the knowledge of the chair is; inf when nothing is known.

        While armed, the age also counts from when the newest command was sent that the chair has acknowledged:
        commands that take long to reach the chair are as bad as none.
        """
        age = t - self.telemetry.t
        return max(age, t - self._echoed) if self._state is State.ARMED and self.telemetry.ready else age

    @property
    def ready(self) -> bool:
        """Whether the chair accepted this arming, and since has had its document and commands without a pause."""
        return self.telemetry.ready and not self._stalled and self._document == self._armed_document

    @property
    def document(self) -> str:
        """The first 16 hexadecimal digits of the chair document's SHA-256; empty: the chair tells of none."""
        return self._document.hex() if any(self._document) else ""

    @property
    def crawls(self) -> bool:
        """Whether the chair misses its document, and so drives at a crawl at most."""
        newest = self.telemetry.newest
        return newest is not None and newest.crawls != 0

    @property
    def inhibited(self) -> bool:
        """Whether the chair's stop switch is pressed, or the chair has a fault."""
        return self.telemetry.inhibited

    @property
    def switch_seen(self) -> bool:
        """Whether the chair has shown its stop switch pressed, so that the switch works."""
        return self.telemetry.switch_seen

    @property
    def switch_reported(self) -> bool:
        """Whether the stop switch was seen, or a telemetry shows it that the next arming has to confirm."""
        return self.telemetry.switch_reported

    @property
    def silent(self) -> bool:
        """Whether no telemetry has come for `SILENT` seconds."""
        return not self._now - self.telemetry.t <= SILENT  # NaN before the first `listen`

    @property
    def stands(self) -> bool:
        """Whether the chair was commanded to stand and reports that it does, or `SETTLE` seconds have passed since."""
        if self._state in RUNNING:
            return False
        v, omega = self._driven()
        return max(abs(v), abs(omega)) <= STANDING or self._now - self._ended > SETTLE

    def lost_key(self) -> Text | None:
        """Return why the chair's key counts no longer, None while it does; reads the key file."""
        return lost_key(Path(self.config.key_file), self._key)

    def description(self) -> Text:
        """Return the chair's state in words."""
        name, place = self.config.name, f"{self.config.host}:{self.config.port}"
        newest = self.telemetry.newest
        if newest is None or self.silent:
            return Text("chairdev-silent", name=name, place=place)
        if self.telemetry.switch_refuted:
            return Text("chairdev-switch-refuted", name=name, place=place)
        return telemetry_description(name, place, newest)

    def report(self, tick: Tick, t: float) -> None:
        """Write into a tick what the chair has reported of itself up to `t` (monotonic s)."""
        tick.chair_kind = 1
        tick.chair_age = self.age(t)
        newest = self.telemetry.newest
        if newest is not None:
            tick.chair_state, tick.chair_fault, tick.stop_input = newest.state, newest.fault, newest.stop_input
            tick.battery, tick.own_joystick = newest.battery, newest.own_joystick
            tick.measured = int(math.isfinite(newest.measured_v))

    @property
    def _document(self) -> bytes:
        """The digest of the chair document that the newest telemetry tells of; zeros: of none."""
        newest = self.telemetry.newest
        return bytes(DIGEST_BYTES) if newest is None else newest.document

    def _driven(self) -> Twist:
        """Return the speeds that the chair measures, or else those that its receiver commands.

        They are zero while the chair is silent, for then it stands by itself.
        """
        newest = self.telemetry.newest
        if newest is None or self.silent:
            return STANDSTILL
        v = newest.measured_v if math.isfinite(newest.measured_v) else newest.v
        omega = newest.measured_omega if math.isfinite(newest.measured_omega) else newest.omega
        return Twist(v, omega) if abs(v) <= FASTEST and abs(omega) <= FASTEST else STANDSTILL

    def _follow(self, state: State, t: float) -> None:
        before, self._state = self._state, state
        if state is State.CHECKING:
            self._flags = self._left = 0
            self._armed_digest, self._armed_document = self._digest, self._document
            self._nonce = b""
            self._stalled = self.telemetry.switch_refuted = False
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

    def _send(self, limits: Speeds, t: float) -> None:
        # Deadlines are absolute; missed ones are skipped.
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
        v, omega = self._twist if armed else STANDSTILL
        command = ChairCommand(
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

    def _update_echo(self, telemetry: Telemetry) -> None:
        if self.telemetry.answers:
            while self._sent and self._sent[0][0] <= telemetry.sequence:
                self._echoed = self._sent.popleft()[1]

    def _received(self) -> bytes | None:
        """Return a datagram, None when none is left; the one byte beyond a frame shows a datagram that is too long."""
        if self._socket is not None:
            try:
                return self._socket.recv(TELEMETRY_BYTES + 1)
            except BlockingIOError:
                return None
            except OSError:
                return b""  # no receiver listened for the datagram sent before
        return None

    def _put(self, datagram: bytes) -> None:
        for _ in range(2):  # the first attempt may fail because no receiver listened for the datagram before
            try:
                if self._socket is not None:
                    self._socket.send(datagram)
            except ConnectionRefusedError:
                continue
            except OSError:
                pass  # no room, no network: the next datagram is newer
            return
