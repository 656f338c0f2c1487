"""The chair's side of the link: `python -m app.hardware.chair.receive --key-file F --output sim|ros2|stdout`.

A process of its own, standard library only, so that it runs on a chair's small board.
"""

import argparse
import math
import signal
import socket
import sys
from collections.abc import Sequence
from pathlib import Path

from app.clock import MonotonicClock
from app.hardware.chair.key import KeyRefused, read_key
from app.hardware.chair.outputs import OUTPUTS, Output, OutputRefused, open_output
from app.hardware.chair.packet import FRAME_BYTES
from app.hardware.chair.reasons import WORDS, Reason
from app.hardware.chair.receiver import OMEGA_MAX, V_MAX, Receiver
from app.hardware.chair.telling import Telling
from app.realtime import go_real_time

STEP = 0.01  # s between two looks at the watch: the finest of safety.md's limits is 100 ms
RECEIVE_BUFFER = 1 << 20  # bytes
PROBE_STEPS = 50  # steps whose lateness is measured at the start
PROBE_LIMIT = 0.01  # s: as much later would make 110 ms of the 100
ENDING_LIMIT = 0.5  # s for the way to standstill when somebody ends this


class Inputs:
    """The chair's own switch and its battery, as files that a board keeps up to date."""

    def __init__(self, stop: Path | None, battery: Path | None) -> None:
        self._stop, self._battery = stop, battery

    @property
    def stop_pressed(self) -> bool:
        """Whether the switch is pressed; a file that does not say 0 counts as a wire that is torn."""
        if self._stop is None:
            return False
        try:
            return not self._stop.read_bytes()[:16].strip().startswith(b"0")
        except OSError:
            return True

    @property
    def battery(self) -> float:
        """Charge, 0..1, NaN when unknown."""
        try:
            charge = float(self._battery.read_bytes()[:32]) if self._battery else math.nan
        except (OSError, ValueError):
            return math.nan
        return charge if 0.0 <= charge <= 1.0 else math.nan


class Chair:
    """Turns in steps of 10 ms until it is told to end."""

    def __init__(
        self, receiver: Receiver, telling: Telling, end: socket.socket, output: Output, inputs: Inputs
    ) -> None:
        self._receiver = receiver
        self._telling = telling
        self._socket = end
        self._output = output
        self._inputs = inputs
        self._clock = MonotonicClock()
        self._output_broken = False
        self.ending = False

    def run(self) -> None:
        """Turn until `ending`, then bring the chair to standstill and say so."""
        due = self._clock.now()
        while not self.ending:
            due = max(due + STEP, self._clock.now() - STEP)
            self._turn(due)
        self._receiver.stop(Reason.ENDING)
        until = self._clock.now() + ENDING_LIMIT
        while any(self._receiver.driven) and self._clock.now() < until:
            due += STEP
            self._clock.sleep_until(due)
            self._step()
        self._step()

    def _turn(self, due: float) -> None:
        """Take what comes until `due`, then step: however much junk comes, the watch is looked at."""
        while (left := due - self._clock.now()) > 0.0:
            self._socket.settimeout(left)
            try:
                datagram, address = self._socket.recvfrom(FRAME_BYTES + 1)
            except (TimeoutError, InterruptedError):
                break
            except OSError:
                continue  # an answer of ours found nobody; that is no news about the chair
            t = self._clock.now()
            if len(datagram) == FRAME_BYTES and self._receiver.take(datagram, t):
                self._telling.commanded_by(address)
                self._step()
            else:
                self._telling.greet(datagram, address, t)
        self._step()

    def _step(self) -> None:
        t = self._clock.now()
        pressed = self._inputs.stop_pressed
        twist = self._receiver.step(t, stop_pressed=pressed, output_broken=self._output_broken)
        state, reason = self._receiver.state, self._receiver.reason
        try:
            self._output.drive(t, state.name.lower(), twist, "" if reason is Reason.NONE else WORDS[reason])
            self._output_broken = False
        except OSError:
            self._output_broken = True
            if not self._output.is_real:
                self.ending = True  # nobody reads any more
        self._telling.tell(t, self._inputs, pressed)


def main(arguments: Sequence[str] | None = None, program: str = "python -m app.hardware.chair.receive") -> int:
    """Run until a signal ends it; return the exit code."""
    given = _parser(program).parse_args(arguments)
    try:
        key = read_key(given.key_file)
        output = open_output(given.output)
        end = _bound(given.bind, given.port)
    except (KeyRefused, OutputRefused, OSError) as error:
        what = (
            f"{given.bind}:{given.port} cannot be listened on ({error.strerror})"
            if isinstance(error, OSError)
            else error
        )
        sys.stderr.write(f"The receiver cannot start: {what}.\n")
        return 2
    receiver = Receiver(key, given.v_max, given.omega_max, refuses_virtual=output.is_real)
    telling = Telling(receiver, key.id, end, given.paired)
    chair = Chair(receiver, telling, end, output, Inputs(given.stop_input, given.battery_input))
    host, port = end.getsockname()[:2]
    for which in (signal.SIGTERM, signal.SIGINT):
        signal.signal(which, lambda *_: setattr(chair, "ending", True))
    words = [f"listening on {host}:{port}", f"At most {given.v_max:g} m/s and {given.omega_max:g} rad/s."]
    for sentence in [*words, *go_real_time(), *_slowness()]:
        sys.stderr.write(f"{sentence}\n")
    sys.stderr.flush()
    try:
        chair.run()
    finally:
        output.close()
        end.close()
    return 0


def _bound(host: str, port: int) -> socket.socket:
    family, kind, protocol, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM)[0]
    end = socket.socket(family, kind, protocol)
    try:
        end.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, RECEIVE_BUFFER)
        end.bind(address)
    except OSError:
        end.close()
        raise
    return end


def _slowness() -> list[str]:
    """Measure for half a second whether this machine keeps the steps; return what is to be said."""
    clock = MonotonicClock()
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


def _parser(program: str) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog=program, description="The chair's side of the link: verifies, watches, ramps, and drives an output."
    )
    parser.add_argument("--key-file", type=Path, required=True, help="the file that pairing made, readable by you only")
    parser.add_argument("--output", choices=list(OUTPUTS), required=True, help="what to drive")
    parser.add_argument("--bind", default="127.0.0.1", help="the address to listen on (default: this machine only)")
    parser.add_argument("--port", type=_port, default=5354, help="the port to listen on; 0 takes any free one")
    parser.add_argument("--v-max", type=_up_to(V_MAX), default=V_MAX, help=f"m/s, at most {V_MAX:g}")
    parser.add_argument("--omega-max", type=_up_to(OMEGA_MAX), default=OMEGA_MAX, help=f"rad/s, at most {OMEGA_MAX:g}")
    parser.add_argument(
        "--paired", type=_address, metavar="HOST:PORT", help="who is told how the chair is, at rest too"
    )
    parser.add_argument(
        "--stop-input", type=Path, metavar="FILE", help="0 in it: not pressed; else, or no file: pressed"
    )
    parser.add_argument("--battery-input", type=Path, metavar="FILE", help="the charge, 0 to 1")
    return parser


def _port(text: str) -> int:
    if not text.isdecimal() or int(text) > 65_535:
        raise argparse.ArgumentTypeError(f"'{text}' is no port, give a number from 0 to 65535")
    return int(text)


def _address(text: str) -> tuple[str, int]:
    host, _, port = text.rpartition(":")
    if not host or not 0 < _port(port) <= 65_535:
        raise argparse.ArgumentTypeError(f"'{text}' is no address, give one as HOST:PORT")
    return host, int(port)


class _up_to:  # noqa: N801
    """A number above 0 and up to a limit."""

    def __init__(self, limit: float) -> None:
        self._limit = limit

    def __call__(self, text: str) -> float:
        try:
            number = float(text)
        except ValueError:
            number = math.nan
        if not 0.0 < number <= self._limit:
            raise argparse.ArgumentTypeError(
                f"'{text}' is out of range, give a number above 0, at most {self._limit:g}"
            )
        return number


if __name__ == "__main__":
    sys.exit(main())
