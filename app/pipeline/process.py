"""The control process: `python -m app.pipeline.process --link-fd FD --ring NAME [--report HOST:PORT]`."""

import argparse
import signal
import socket
import sys

from app.clock import MonotonicClock
from app.faults import Fault
from app.file_modes import keep_new_files_private
from app.hardware.base import HardwareError
from app.hardware.chair.report import ChairReport
from app.pipeline.commands import Commands
from app.pipeline.loop import ControlLoop
from app.pipeline.setup import Setup
from app.process.command_channel import CommandServer
from app.process.ring import TickRing
from app.realtime import go_real_time
from app.texts import Text

POLL_EVERY = 0.004  # s between two polls of the control link
LAST_TURNS = 0.5  # s: longest time for the last stop; the gate's STOP_TIME is shorter


def main(arguments: list[str] | None = None) -> int:
    """Run until the control link ends; return the exit code."""
    options = _parser().parse_args(arguments)
    clock = MonotonicClock()
    control_link = None
    try:
        report = ChairReport(*options.report) if options.report else None
        control_link = socket.socket(fileno=options.link_fd)
        ring = TickRing.create(options.ring)
    except (HardwareError, OSError) as error:
        if control_link is not None:
            control_link.close()
        sys.stderr.write(f"The control process cannot start: {error}\n")
        return 2
    keep_new_files_private()
    try:
        server = CommandServer(control_link)
        setup = Setup(clock)
        loop = ControlLoop(setup, ring, report, clock)
        commands = Commands(loop, server, [Text(message) for message in go_real_time()], clock)
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the web process
        signal.signal(signal.SIGTERM, lambda *_: setattr(commands, "quit", True))
        _run_until_quit(loop, commands, server, clock)
        _come_to_a_stop(loop, clock)
        commands.close()
        setup.close()
    finally:
        ring.unlink()
    return 0


def _run_until_quit(loop: ControlLoop, commands: Commands, server: CommandServer, clock: MonotonicClock) -> None:
    next_poll = clock.now()
    while not (commands.quit or server.closed):
        loop.turn()
        now = clock.now()
        if now >= next_poll:
            next_poll = now + POLL_EVERY
            commands.poll()
            loop.send_to_chair()  # a stop does not wait for the next tick


def _come_to_a_stop(loop: ControlLoop, clock: MonotonicClock) -> None:
    """Turn on, recording included, until the gate has brought the chair to its stop and all commands are sent."""
    loop.setup.chain.gate.stop(Fault.WEB_SILENT)
    loop.send_to_chair()
    until = clock.now() + LAST_TURNS
    loop.turn()
    while not (loop.setup.stands and loop.all_commands_sent) and clock.now() < until:
        loop.turn()


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m app.pipeline.process", description="The control process.")
    parser.add_argument("--link-fd", type=int, required=True, help="an open end of a stream socket pair")
    parser.add_argument("--ring", required=True, help="name of the shared memory to make for the ticks")
    parser.add_argument("--report", type=_address, metavar="HOST:PORT", help="send this address where the chair is")
    return parser


def _address(text: str) -> tuple[str, int]:
    host, _, port = text.rpartition(":")
    if not host or not port.isdecimal() or not 0 < int(port) < 65_536:
        raise argparse.ArgumentTypeError(f"'{text}' is no address, give one as HOST:PORT")
    return host, int(port)


if __name__ == "__main__":
    sys.exit(main())
