"""`bodydrive replay`: a recorded run as a shirt that sends datagrams."""

import json
import math
import socket
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.common_options import AsJson
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.output import warn
from app.cli.signal_options import (
    ChannelNames,
    SampleRate,
    TimeName,
    TimeUnit,
    reading_options,
    signals_refused,
)
from app.clock import Clock, MonotonicClock
from app.hardware.shirt.sender import STANDARD_ADDRESS
from app.texts import Figure, Text

if TYPE_CHECKING:
    from app.hardware.shirt.playback import FrameFile

SLOWEST, FASTEST = 0.01, 100.0  # times the recorded rate


def replay(
    recording: Annotated[Path, typer.Argument(metavar="RECORDING", help=help_text("cli-help-replay-recording"))],
    to: Annotated[str, typer.Option(help=help_text("cli-help-replay-to"))] = STANDARD_ADDRESS,
    loop: Annotated[bool, typer.Option("--loop", help=help_text("cli-help-replay-loop"))] = False,
    speed: Annotated[float, typer.Option(help=help_text("cli-help-replay-speed"))] = 1.0,
    *,
    time: TimeName = None,
    unit: TimeUnit = None,
    rate: SampleRate = None,
    channels: ChannelNames = None,
    as_json: AsJson = False,
) -> None:
    """Play a recorded run as a shirt source: its frames as datagrams, at their own times. Ctrl-C ends it."""
    from app.hardware.base import HardwareError
    from app.hardware.shirt.playback import read_frames

    if not SLOWEST <= speed <= FASTEST:
        raise InputError(Text("cli-replay-speed", speed=f"{speed:g}", least=f"{SLOWEST:g}", most=f"{FASTEST:g}"))
    family, address = parse_address(to)
    options = reading_options(time, unit, rate, channels)
    try:
        file = read_frames(recording, options)
    except HardwareError as error:
        raise signals_refused(error) from error
    warn(file.note)
    if not as_json:
        begins = Text(
            "cli-replay-loops" if loop else "cli-replay-begins",
            name=file.name,
            to=to,
            channels=len(file.layout.channels),
            rate=round(file.sample_rate * speed, 3),
            seconds=Figure(file.t[-1] / speed, 1),
        )
        typer.echo(begins)
    with socket.socket(family, socket.SOCK_DGRAM) as sender:
        sent, stopped, trouble = play(
            file, lambda packet: _send(sender, packet, address), MonotonicClock(), loop, speed
        )
    if trouble:
        raise InputError(Text("cli-replay-failed", to=to, reason=trouble))
    if as_json:
        typer.echo(json.dumps({"frames": sent, "to": to, "stopped": stopped}))
    else:
        typer.echo(Text("cli-replay-stopped" if stopped else "cli-replay-ended", frames=sent))


def parse_address(text: str) -> tuple[socket.AddressFamily, tuple[str, int]]:
    """Return the family and the socket address of HOST:PORT, or raise InputError."""
    host, colon, port = text.rpartition(":")
    if not colon or not host or not port.isascii() or not port.isdecimal() or not 0 < int(port) <= 65_535:
        raise InputError(Text("cli-replay-address", to=text, example=STANDARD_ADDRESS))
    try:
        family, _, _, _, address = socket.getaddrinfo(host.strip("[]"), int(port), type=socket.SOCK_DGRAM)[0]
    except (OSError, UnicodeError) as error:
        raise InputError(Text("cli-replay-no-host", to=text)) from error
    return family, (str(address[0]), int(address[1]))


def play(
    file: "FrameFile", send: Callable[[bytes], str], clock: Clock, loop: bool, speed: float
) -> tuple[int, bool, str]:
    """Send the frames at their recorded times divided by `speed`, each with its recorded device time.

    Return how many frames were sent, whether Ctrl-C ended the replay, and the error that `send` returned.
    """
    from app.hardware.shirt.packet import encode
    from app.hardware.shirt.playback import FramePlayer

    player = FramePlayer(file, loop)
    start = clock.now()
    sent = 0
    try:
        while not math.isinf(player.due):
            clock.sleep_until(start + player.due / speed)
            seq, t, values = player.next_frame()
            if trouble := send(encode(seq, t, values)):
                return sent, False, trouble
            sent += 1
    except KeyboardInterrupt:
        return sent, True, ""
    return sent, False, ""


def _send(sender: socket.socket, packet: bytes, address: tuple[str, int]) -> str:
    """Send one datagram; return the error as text, empty when there is none."""
    try:
        sender.sendto(packet, address)
    except OSError as error:
        return error.strerror or str(error)
    return ""
