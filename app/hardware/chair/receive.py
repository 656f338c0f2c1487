"""The chair's side of the chair link: `python -m app.hardware.chair.receive --key-file F --output sim|ros2|stdout`.

A separate process, standard library only, so that it runs on a chair's small board (also as `python -S`).
"""

import argparse
import math
import signal
import socket
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import NoReturn, cast

from app.clock import MonotonicClock
from app.hardware.chair.inputs import Inputs
from app.hardware.chair.key import KeyRefused, read_key
from app.hardware.chair.outputs import OUTPUTS, OutputRefused, open_output
from app.hardware.chair.packet import PORT
from app.hardware.chair.receiver import OMEGA_MAX, V_MAX, Receiver
from app.hardware.chair.receiver_loop import ReceiverLoop, slowness
from app.hardware.chair.telemetry_sender import TelemetrySender
from app.hardware.shirt.sender_choice import Address
from app.realtime import go_real_time

RECEIVE_BUFFER = 1 << 20  # bytes: room for a command behind the datagrams of a flood that come while the loop sleeps
DESCRIPTION = """The chair's side of the link: checks every command, watches the time, ramps, and drives an output.
What drives the motors must itself stop when nothing comes from here any more."""


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
        *go_real_time(),
        *slowness(clock),
    ):
        _complain(sentence)
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
        why = getattr(error, "strerror", None) or "no host name"
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
    add("--port", type=_port, default=PORT, help=f"the port to listen on (default {PORT}); 0 takes a free one")
    add("--v-max", type=_up_to(V_MAX), default=V_MAX, metavar="M_PER_S", help=f"at most {V_MAX:g}, the default")
    add("--omega-max", type=_up_to(OMEGA_MAX), default=OMEGA_MAX, metavar="RAD_PER_S", help=f"at most {OMEGA_MAX:g}")
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
