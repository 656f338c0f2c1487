"""A shirt that signs its frames, as a model for a shirt's firmware: `bodydrive shirt send --key-file F`.

Standard library only (it also runs as `python -S -m app.hardware.shirt.sender`). The bytes are those of
docs/protocols.md, section 6.
"""

import argparse
import csv
import hmac
import math
import socket
import struct
import sys
import zlib
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from pathlib import Path
from typing import NoReturn

from app.clock import MonotonicClock
from app.files import write_atomically
from app.hardware.chair.key import Key, KeyRefused, read_key
from app.ports import SHIRT_PORT

HEADER = struct.Struct("<4sBBHIQ")  # magic, version, flags, channels, seq, device time in microseconds
SIGNER = struct.Struct("<HQ")  # key id, boot counter
SIGNED = 2  # the flag of a signed frame of float32 samples
TAG_BYTES = 16
LARGEST_SEQ = 0xFFFFFFFF
LARGEST_FILE = 64_000_000  # bytes
LARGEST_SAMPLE = 3.4e38  # of a float32
MOST_CHANNELS = 64
STANDARD_ADDRESS = f"127.0.0.1:{SHIRT_PORT}"
DESCRIPTION = """Sends frames as a shirt does that was paired: each signed, counted, and never the same twice.
Without --file the samples are slow waves."""


class CannotSend(Exception):  # noqa: N818
    """Why nothing is sent, in one sentence."""


def signed_frame(key: Key, boot: int, seq: int, microseconds: int, samples: Sequence[float]) -> bytes:
    """Return the datagram of one frame.

    Parameters
    ----------
    key : Key
        The key made by pairing: its number and its 32 bytes.
    boot : int
        u64, higher at each start of the device than at any start before, kept in storage that survives a power cut.
    seq : int
        u32, one more at each frame; before it wraps to 0, `boot` is raised.
    microseconds : int
        u64, the device's own time.
    samples : sequence of float
        One per channel; sent as float32.
    """
    head = HEADER.pack(b"SHRT", 1, SIGNED, len(samples), seq, microseconds) + SIGNER.pack(key.id, boot)
    body = head + struct.pack(f"<{len(samples)}f", *samples)
    signed = body + hmac.digest(key.secret, body, "sha256")[:TAG_BYTES]
    return signed + struct.pack("<I", zlib.crc32(signed))


def next_boot(file: Path) -> int:
    """Raise the boot counter in `file`, and return it when it is on the disk; CannotSend for an invalid file."""
    try:
        text = file.read_text(encoding="ascii").strip() if file.exists() else "0"
        if not text.isdecimal() or int(text) >= 2**64 - 1:
            raise CannotSend(f"{file} holds no boot counter: pair the shirt anew")
        boot = int(text) + 1
        write_atomically(file, f"{boot}\n".encode())
    except (OSError, UnicodeDecodeError) as error:
        why = error.strerror if isinstance(error, OSError) else "it is no text"
        raise CannotSend(f"the boot counter {file} cannot be kept ({why}): name another --boot-file") from error
    return boot


def waves(channels: int, rate: float) -> Iterator[tuple[float, list[float]]]:
    """Yield times (s) and samples endlessly: a slow wave in each channel."""
    count = 0
    while True:
        t = count / rate
        yield t, [0.5 + 0.1 * math.sin(math.tau * (0.2 * t + i / channels)) for i in range(channels)]
        count += 1


def rows_of(file: Path) -> list[tuple[float, list[float]]]:
    """Return times (s, from 0) and samples of a CSV with a column t and a channel in each other column."""
    try:
        if not file.is_file() or file.stat().st_size > LARGEST_FILE:
            raise CannotSend(f"{file} is no CSV file of at most {LARGEST_FILE // 1_000_000} MB: name another one")
        with file.open(encoding="utf-8-sig", newline="") as opened:
            lines = csv.reader(opened)
            names = next(lines)
            place = names.index("t")
            numbers = [[float(cell) for cell in line] for line in lines if line]
    except (OSError, ValueError, StopIteration, csv.Error) as error:
        raise CannotSend(f"{file} cannot be sent ({error}): it needs a column t and numbers beside it") from error
    if len(numbers) < 2 or not 2 <= len(names) <= MOST_CHANNELS + 1 or any(len(row) != len(names) for row in numbers):
        raise CannotSend(f"{file}: give two rows or more, each with t and 1 to {MOST_CHANNELS} channels")
    rows = [(row[place] - numbers[0][place], row[:place] + row[place + 1 :]) for row in numbers]
    if not all(earlier < later < math.inf for (earlier, _), (later, _) in pairwise(rows)):
        raise CannotSend(f"{file}: its times do not rise, record it again")
    if any(abs(sample) > LARGEST_SAMPLE for _, samples in rows for sample in samples):
        raise CannotSend(f"{file}: a sample is too large for a float32, correct it")
    return rows


def again(rows: list[tuple[float, list[float]]]) -> Iterator[tuple[float, list[float]]]:
    """Yield the rows in an endless loop."""
    length = rows[-1][0] + rows[1][0]
    begin = 0.0
    while True:
        for t, samples in rows:
            yield begin + t, samples
        begin += length


def main(arguments: Sequence[str] | None = None, program: str = "python -m app.hardware.shirt.sender") -> int:
    """Send until the file or the frames end, or Ctrl-C; return the exit code."""
    given = _parser(program).parse_args(arguments)
    boot_file = given.boot_file or given.key_file.with_suffix(".boot")
    try:
        key = read_key(given.key_file)
        rows = rows_of(given.file) if given.file else None
        family, address = _address(given.to)
        boot = next_boot(boot_file)
        frames = waves(given.channels, given.rate) if rows is None else again(rows) if given.loop else iter(rows)
        sys.stderr.write(f"Sending to {address[0]}:{address[1]}, key {key.id}, start {boot}. Ctrl-C ends it.\n")
        sent = _send(frames, key, boot, boot_file, family, address, given.frames)
    except (KeyRefused, CannotSend) as error:
        sys.stderr.write(f"{program}: {error}\n")
        return 2
    sys.stderr.write(f"{sent} frames sent.\n")
    return 0


def _send(
    frames: Iterator[tuple[float, list[float]]],
    key: Key,
    boot: int,
    boot_file: Path,
    family: int,
    address: tuple[str, int],
    most: int | None,
) -> int:
    """Send each frame at its own time; return how many were sent."""
    clock = MonotonicClock()
    start, seq, sent = clock.now(), 0, 0
    with socket.socket(family, socket.SOCK_DGRAM) as sender:
        try:
            for t, samples in frames:
                if sent == most:
                    break
                clock.sleep_until(start + t)
                sender.sendto(signed_frame(key, boot, seq, round(t * 1e6), samples), address)
                sent += 1
                seq += 1
                if seq > LARGEST_SEQ:
                    boot, seq = next_boot(boot_file), 0
        except KeyboardInterrupt:
            pass
        except OSError as error:
            raise CannotSend(f"nothing can be sent there ({error.strerror}): give another --to") from error
    return sent


def _address(place: tuple[str, int]) -> tuple[int, tuple[str, int]]:
    try:
        family, _, _, _, address = socket.getaddrinfo(*place, type=socket.SOCK_DGRAM)[0]
    except (OSError, UnicodeError) as error:
        raise CannotSend(f"there is no host of the name {place[0]}: correct --to") from error
    return family, (str(address[0]), int(address[1]))


class _SenderParser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        """Refuse in one sentence, without the usage above it."""
        sys.stderr.write(f"{self.prog}: {message}: see {self.prog} --help\n")
        sys.exit(2)


def _parser(program: str) -> argparse.ArgumentParser:
    parser = _SenderParser(prog=program, description=DESCRIPTION, allow_abbrev=False)
    add = parser.add_argument
    add("--key-file", type=Path, required=True, metavar="FILE", help="what pairing made, readable by you only")
    add("--boot-file", type=Path, metavar="FILE", help="where the starts are counted (default: beside the key)")
    add("--to", type=_place, default=_place(STANDARD_ADDRESS), metavar="HOST:PORT", help=f"({STANDARD_ADDRESS})")
    add("--file", type=Path, metavar="CSV", help="a column t (s) and a channel in each other column")
    add("--loop", action="store_true", help="begin the file again at its end")
    add("--channels", type=_whole(MOST_CHANNELS), default=52, metavar="N", help="channels of the waves (52)")
    add("--rate", type=_whole(2000), default=100, metavar="HZ", help="frames of the waves a second (100)")
    add("--frames", type=_whole(10**9), metavar="N", help="end after so many")
    return parser


def _place(text: str) -> tuple[str, int]:
    host, _, port = text.rpartition(":")
    if not host or not (port.isascii() and port.isdecimal()) or not 0 < int(port) <= 65_535:
        raise argparse.ArgumentTypeError(f"'{text}' is no address, give one as HOST:PORT")
    return host.strip("[]"), int(port)


def _whole(most: int) -> Callable[[str], int]:
    def number(text: str) -> int:
        if text.isascii() and text.isdecimal() and 0 < int(text[:12]) <= most:
            return int(text)
        raise argparse.ArgumentTypeError(f"'{text}' is out of range, give a whole number from 1 to {most}")

    return number


if __name__ == "__main__":
    sys.exit(main())
