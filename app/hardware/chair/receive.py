"""The chair's side of the chair link: `python -m app.hardware.chair.receive --key-file F --output sim|ros2|stdout`.

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
from app.hardware.chair.outputs import OUTPUTS, Output, OutputRefused, open_output
from app.hardware.chair.packet import FRAME_BYTES
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


class CannotStart(Exception):  # noqa: N818
    """Why the receiver does not start, in one sentence."""


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        """Refuse in one sentence, without the usage above it."""
        _complain(f"{self.prog}: {message}: see {self.prog} --help")
        sys.exit(2)


def main(arguments: Sequence[str] | None = None, program: str = "python -m app.hardware.chair.receive") -> int:
    """Run until a signal ends it; return the exit code."""
    given = _parser(program).parse_args(arguments)
    try:
        key = read_key(given.key_file)
        end = _bound(given.bind, given.port)
        paired = _address(given.paired, end.family) if given.paired else None
        output = open_output(given.output)
    except (KeyRefused, OutputRefused, CannotStart) as error:
        _complain(f"{program}: {error}")
        return 2
    clock = MonotonicClock()
    receiver = Receiver(key, given.v_max, given.omega_max, refuses_virtual=output.is_real)
    inputs = Inputs(given.stop_input, given.battery_input)
    loop = ReceiverLoop(receiver, TelemetrySender(receiver, key.id, end, paired), end, output, inputs, clock)
    for which in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        if which is not signal.SIGHUP or signal.getsignal(which) is not signal.SIG_IGN:  # ignored under nohup
            signal.signal(which, lambda *_: setattr(loop, "ending", True))
    host, port = end.getsockname()[:2]
    place = f"[{host}]:{port}" if ":" in host else f"{host}:{port}"
    for sentence in (
        f"listening on {place}",
        f"At most {given.v_max:g} m/s and {given.omega_max:g} rad/s, output {given.output}.",
        *(REAL_TIME[message] for message in go_real_time()),
        *slowness(clock),
    ):
        _complain(str(sentence))
    try:
        loop.run()
    finally:
        with suppress(OSError):  # the output may be broken
            output.close()
        end.close()
    return 0


def _complain(sentence: str) -> None:
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
    parser = _Parser(prog=program, description=DESCRIPTION, allow_abbrev=False)
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
        type=_up_to(HIGHEST_SPEED),
        default=HIGHEST_SPEED,
        metavar="M_PER_S",
        help=f"at most {HIGHEST_SPEED:g}, the default",
    )
    add(
        "--omega-max",
        type=_up_to(HIGHEST_TURN_RATE),
        default=HIGHEST_TURN_RATE,
        metavar="RAD_PER_S",
        help=f"at most {HIGHEST_TURN_RATE:g}",
    )
    add("--paired", type=_host_and_port, metavar="HOST:PORT", help="where telemetry is sent at rest, too")
    add("--stop-input", type=Path, metavar="FILE", help="begins with 0: not pressed; anything else, or none: pressed")
    add("--battery-input", type=Path, metavar="FILE", help="the charge, a number from 0 to 1")
    return parser


def _port(text: str) -> int:
    if not (text.isascii() and text.isdecimal()) or int(text) > 65_535:
        raise argparse.ArgumentTypeError(f"'{text}' is no port, give a number from 0 to 65535")
    return int(text)


def _host_and_port(text: str) -> tuple[str, int]:
    host, _, port = text.rpartition(":")
    if not host or not _port(port):
        raise argparse.ArgumentTypeError(f"'{text}' is no address, give one as HOST:PORT")
    return host.strip("[]"), int(port)


def _up_to(limit: float) -> Callable[[str], float]:
    def number(text: str) -> float:
        with suppress(ValueError):
            if 0.0 < (given := float(text)) <= limit and math.isfinite(given):
                return given
        raise argparse.ArgumentTypeError(f"'{text}' is out of range, give a number above 0, at most {limit:g}")

    return number


if __name__ == "__main__":
    sys.exit(main())
