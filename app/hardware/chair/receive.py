"""The chair's side of the chair link: `python -m app.hardware.chair.receive --key-file F --output NAME`.

A separate process, standard library only, so that it runs on a chair's small board (also as `python -S`).
"""

import argparse
import math
import select
import signal
import socket
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import NoReturn, cast

from app.clock import Clock, MonotonicClock
from app.hardware.chair.inputs import Inputs
from app.hardware.chair.key import KeyRefused, read_key
from app.hardware.chair.outputs import OUTPUTS, Output, OutputRefused, Sink, open_output
from app.hardware.chair.packet import FRAME_BYTES
from app.hardware.chair.readings import NO_READINGS
from app.hardware.chair.reasons import DESCRIPTIONS, Reason
from app.hardware.chair.receiver import Receiver
from app.hardware.chair.telemetry_sender import TelemetrySender
from app.hardware.shirt.sender_choice import Address
from app.ports import RECEIVER_PORT
from app.realtime import go_real_time
from app.speed_ceiling import HIGHEST_SPEED, HIGHEST_TURN_RATE

RECEIVE_BUFFER = 1 << 20  # bytes: room for a command behind the datagrams of a flood that come while the loop sleeps
DESCRIPTION = """The chair's side of the link: checks every command, watches the time, ramps, and drives an output.
What drives the motors must itself stop when nothing comes from here any more."""

STEP = 0.01  # s between two checks of the limits; the shortest limit of safety.md is 100 ms
LEAST = 0.001  # s to listen, also after a hold-up
DRAINING = 0.005  # s of a step for other datagrams than commands: leaves time to other programs in a flood
ENDING_LIMIT = 0.5  # s for the ramp to standstill at the end
PROBE_STEPS = 50  # number of steps whose lateness is measured at the start
PROBE_LIMIT = 0.01  # s of lateness, with which the limit of 100 ms becomes 110 ms
CHECK_TIME = 2.0  # s for which --check looks at an output
STDERR = 2
TELL_EVERY = 1.0  # s between two lines about the same trouble: what comes and goes must not fill a log
NARROWEST, WIDEST = 0.3, 0.9  # m between the driven wheels of a chair

# What `go_real_time` was granted; the catalogue has the same sentences.
REAL_TIME = {
    "realtime-granted": "The control loop has real-time scheduling.",
    "realtime-refused": "Real-time scheduling was not granted: close other programs while driving.",
    "realtime-memory-refused": "Memory is not kept in RAM: a machine short of memory may delay the control loop.",
    "realtime-memory-locked": "The control loop's memory is kept in RAM.",
}


class ReceiverLoop:
    """Turns in steps until `ending`; checks the time limits every 10 ms, whatever comes in.

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
        self._refusal = ""  # why the output did not take the last command; empty: it did
        self._errors = Sink(STDERR)
        self._told = self._last_trouble = ""  # what was told of the output last; the last trouble among that
        self._tell_due = -math.inf  # s
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
        try:
            readings, trouble = self._output.poll(t), self._refusal
        except OSError as error:
            readings, trouble = NO_READINGS, why_of(error)
        output_obstacle = Reason.OUTPUT if trouble else readings.obstacle
        twist = self._receiver.step(t, Reason.STOP_INPUT if pressed else output_obstacle)
        state, reason = self._receiver.state, self._receiver.reason
        try:
            self._output.drive(t, state.name.lower(), twist, "" if reason is Reason.NONE else DESCRIPTIONS[reason])
            self._refusal = ""
        except OSError as error:
            self._refusal = why_of(error)
            if not self._output.is_real:
                self.ending = True  # the reader has gone
        self._telemetry.send(t, self._inputs, pressed, readings, now=last)
        self._tell(t, trouble or (DESCRIPTIONS[output_obstacle] if output_obstacle else ""))

    def _tell(self, t: float, trouble: str) -> None:
        """Write a line when the output begins to fail, fails in another way, or works again; never wait for that."""
        is_another = trouble not in ("", self._last_trouble)
        if trouble == self._told or (t < self._tell_due and not is_another):
            return
        with suppress(OSError):  # nobody reads stderr
            self._errors.put(f"output: {trouble or 'it works again'}")
        self._told, self._tell_due = trouble, t + TELL_EVERY
        self._last_trouble = trouble or self._last_trouble


def check(output: Output, clock: Clock) -> int:
    """Look at an output for two seconds without driving; print what was found, and return the exit code."""
    trouble = ""
    until = clock.now() + CHECK_TIME
    while (t := clock.now()) < until:
        try:
            obstacle = output.poll(t).obstacle
            trouble = DESCRIPTIONS[obstacle] if obstacle else ""
        except OSError as error:
            trouble = f"It cannot be driven: {why_of(error)}."
        clock.sleep_until(t + STEP)
    sys.stdout.write(f"{output.description()}\n{trouble or 'It can be driven.'}\nNothing was moved.\n")
    with suppress(OSError):
        output.close()
    return 1 if trouble else 0


def why_of(error: OSError) -> str:
    """Return the reason of an error in words."""
    return error.strerror or str(error) or type(error).__name__


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


class CannotStart(Exception):  # noqa: N818
    """Why the receiver does not start, in one sentence."""


class ProgramParser(argparse.ArgumentParser):
    """A parser that refuses in one sentence, with exit code 2."""

    def error(self, message: str) -> NoReturn:
        """Refuse in one sentence, without the usage above it."""
        complain(f"{self.prog}: {message}: see {self.prog} --help")
        sys.exit(2)


def main(arguments: Sequence[str] | None = None, program: str = "python -m app.hardware.chair.receive") -> int:
    """Run until a signal ends it; return the exit code."""
    given = _parser(program).parse_args(arguments)
    clock = MonotonicClock()
    try:
        key = read_key(given.key_file)
        if given.check:
            return check(open_output(given.output, vars(given)), clock)
        end = _bound(given.bind, given.port)
        paired = _address(given.paired, end.family) if given.paired else None
        output = open_output(given.output, vars(given))
    except (KeyRefused, OutputRefused, CannotStart) as error:
        complain(f"{program}: {error}")
        return 2
    v_max, omega_max = min(given.v_max, output.most.v), min(given.omega_max, output.most.omega)
    receiver = Receiver(key, v_max, omega_max, refuses_virtual=output.is_real, table=output.table)
    inputs = Inputs(given.stop_input, given.battery_input)
    loop = ReceiverLoop(receiver, TelemetrySender(receiver, key.id, end, paired), end, output, inputs, clock)
    for which in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        if which is not signal.SIGHUP or signal.getsignal(which) is not signal.SIG_IGN:  # ignored under nohup
            signal.signal(which, lambda *_: setattr(loop, "ending", True))
    host, port = end.getsockname()[:2]
    place = f"[{host}]:{port}" if ":" in host else f"{host}:{port}"
    for sentence in (
        f"listening on {place}",
        f"At most {v_max:.3g} m/s and {omega_max:.3g} rad/s, output {given.output}.",
        *(REAL_TIME[message] for message in go_real_time()),
        *slowness(clock),
    ):
        complain(str(sentence))
    try:
        loop.run()
    finally:
        with suppress(OSError):  # the output may be broken
            output.close()
        end.close()
    return 0


def complain(sentence: str) -> None:
    """Write a line to the standard error."""
    with suppress(OSError):  # nobody reads stderr; the chair is driven all the same
        sys.stderr.write(f"{sentence}\n")
        sys.stderr.flush()


def _bound(host: str, port: int) -> socket.socket:
    """Return a non-blocking socket that listens on `host` and `port`."""
    try:
        family, kind, protocol, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM)[0]
        end = socket.socket(family, kind, protocol)
        try:
            end.setblocking(False)
            end.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, RECEIVE_BUFFER)
            end.bind(address)
        except OSError:
            end.close()
            raise
    except (OSError, UnicodeError) as error:
        why = getattr(error, "strerror", None) or "no such host name"
        raise CannotStart(f"cannot listen on {host}:{port} ({why}), choose another --bind or --port") from error
    return end


def _address(place: tuple[str, int], family: int) -> Address:
    """Return the socket address of a host and port; names are looked up here, never while driving."""
    host, port = place
    try:
        return cast(Address, socket.getaddrinfo(host, port, family=family, type=socket.SOCK_DGRAM)[0][4])
    except (OSError, UnicodeError) as error:
        raise CannotStart(f"--paired {host}:{port} is not an address like that of --bind, correct it") from error


def _parser(program: str) -> argparse.ArgumentParser:
    parser = ProgramParser(prog=program, description=DESCRIPTION, allow_abbrev=False)
    add = parser.add_argument
    add("--key-file", type=Path, required=True, metavar="FILE", help="what pairing made, readable by you only")
    add("--output", choices=list(OUTPUTS), required=True, help="what to drive")
    add("--bind", default="127.0.0.1", metavar="HOST", help="the address to listen on (default: this machine only)")
    add(
        "--port",
        type=_port,
        default=RECEIVER_PORT,
        help=f"the port to listen on (default {RECEIVER_PORT}); 0 takes a free one",
    )
    add(
        "--v-max",
        type=up_to(HIGHEST_SPEED),
        default=HIGHEST_SPEED,
        metavar="M_PER_S",
        help=f"at most {HIGHEST_SPEED:g}, the default",
    )
    add(
        "--omega-max",
        type=up_to(HIGHEST_TURN_RATE),
        default=HIGHEST_TURN_RATE,
        metavar="RAD_PER_S",
        help=f"at most {HIGHEST_TURN_RATE:g}",
    )
    add("--paired", type=host_and_port, metavar="HOST:PORT", help="where telemetry is sent at rest, too")
    add("--stop-input", type=Path, metavar="FILE", help="begins with 0: not pressed; anything else, or none: pressed")
    add("--battery-input", type=Path, metavar="FILE", help="the charge, a number from 0 to 1")
    add("--check", action="store_true", help="move nothing, say what is found at the output, and end")
    own = parser.add_argument_group("of some outputs only").add_argument
    own("--device", metavar="FILE", help="whill, analog: the serial line, such as one in /dev/serial/by-id")
    own("--tread", type=_tread, metavar="M", help="whill: between the middles of the driven wheels, by a tape measure")
    own("--backward-motor", choices=["right", "left", "none"], help="whill: the one that is negative forwards")
    own("--topic", metavar="NAME", help="ros2: where to publish (default /cmd_vel)")
    own("--message", choices=["Twist", "TwistStamped"], help="ros2: of which type (default Twist)")
    own("--frame", metavar="NAME", help="ros2: of a TwistStamped (default base_link)")
    own("--chair-document", type=Path, metavar="FILE", help="luci, analog: which deflection gives which speed")
    return parser


def _port(text: str) -> int:
    if not (text.isascii() and text.isdecimal()) or int(text) > 65_535:
        raise argparse.ArgumentTypeError(f"'{text}' is no port, give a number from 0 to 65535")
    return int(text)


def host_and_port(text: str) -> tuple[str, int]:
    """Read HOST:PORT, for an option of a parser."""
    host, _, port = text.rpartition(":")
    if not host or not _port(port):
        raise argparse.ArgumentTypeError(f"'{text}' is no address, give one as HOST:PORT")
    return host.strip("[]"), int(port)


def _tread(text: str) -> float:
    with suppress(ValueError):
        if NARROWEST <= (given := float(text)) <= WIDEST:
            return given
    raise argparse.ArgumentTypeError(f"'{text}' is no tread, give a number of metres from {NARROWEST} to {WIDEST}")


def up_to(limit: float) -> Callable[[str], float]:
    """Return a function that reads a number above 0 and at most `limit`, for an option of a parser."""

    def number(text: str) -> float:
        with suppress(ValueError):
            if 0.0 < (given := float(text)) <= limit and math.isfinite(given):
                return given
        raise argparse.ArgumentTypeError(f"'{text}' is out of range, give a number above 0, at most {limit:g}")

    return number


if __name__ == "__main__":
    sys.exit(main())
