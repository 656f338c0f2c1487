"""What a board sends on a serial line: bytes in, frames out, and counts of what is lost or unreadable. No port.

The formats are those of docs/protocols.md, section 14; examples/firmware/wired_shirt sends both.
"""

import math
import re
from binascii import crc_hqx
from struct import Struct
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from app.hardware.shirt.frame_order import WRAP, Lateness
from app.layout import MAX_CHANNELS
from app.messages import SensorFrame
from app.texts import Text

HEADER = Struct("<HI")
"""Frame number (u16) and the board's time (u32, microseconds)."""
CHECKSUM = Struct("<H")
CHECKSUM_START = 0xFFFF  # CRC-16/CCITT-FALSE: polynomial 0x1021, nothing reflected or inverted
MISSING = -32768  # the int16 of a sensor without a value
NUMBERS = 1 << 16  # frame numbers, after which a board begins at 0 again
SHORTEST_BODY = HEADER.size + 2 + CHECKSUM.size  # bytes
LONGEST_BODY = HEADER.size + 2 * MAX_CHANNELS + CHECKSUM.size  # bytes; COBS adds one to fewer than 255
LONGEST_LINE = 32 * MAX_CHANNELS  # bytes

LONGEST_CUT = 1_000_000  # microseconds: frames missing for longer are not counted, the board may have begun anew
SHORTEST_PERIOD = 250  # microseconds: a frame number that runs on faster is that of a board which began anew
CLOCK_ERROR = 0.01  # s per s: the ceramic resonators of cheap boards are wrong by half of it
PAUSE = 0.1  # s without a line that counts as a gap: a computer may hand lines on in bursts nearly as long
PAUSE_PERIODS = 3

NUMBER = re.compile(rb"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d{1,3})?")
NO_NUMBER = re.compile(rb"([+-]?(nan|inf|ovf))?", re.IGNORECASE)
"""What stands in a line where a value is missing; Arduino prints `inf` and `ovf` for what is too large."""
SEPARATORS = (b";", b",", b"\t")  # the first of these in a line separates its numbers; without any, blanks do
LARGEST = float(np.finfo(np.float32).max)
FOREIGN = Text("shirtdev-serial-foreign")

BoardFrame = tuple[int, int, NDArray[np.float32]]
"""Frame number, the board's time in microseconds, values (n_channels,)."""


class SerialDecoder(Protocol):
    """Makes frames of the bytes of one board."""

    lost: int
    """Frames that are missing in the board's count, or could not be read."""
    junk: int
    """Pieces of the stream that are no frame of this shirt."""
    refusal: Text | None
    """Why the newest of these is none."""
    late_by: float
    """How late the newest frame came by the board's clock (s); 0: not late, or the board does not say its time."""

    def feed(self, content: bytes, t: float) -> list[SensorFrame]:
        """Return the frames that end in `content`, which came at `t` (monotonic s)."""
        ...

    def begin_anew(self) -> None:
        """Expect the stream of a port that was opened again; the counts go on."""
        ...


class DelimitedPieces:
    """Splits a stream at a delimiter, from any byte on. A piece that is too long is cut to `longest` + 1 bytes."""

    def __init__(self, delimiter: bytes, longest: int) -> None:
        self._delimiter = delimiter
        self._longest = longest
        self.begin_anew()

    def begin_anew(self) -> None:
        """Expect another stream."""
        self._rest = b""
        self._is_whole = False  # whether the beginning of the rest was seen

    def feed(self, content: bytes) -> list[tuple[bytes, bool]]:
        """Return the pieces that end in `content`, each with whether it was seen from its beginning."""
        *ended, rest = (self._rest + content).split(self._delimiter)
        self._rest = rest[: self._longest + 1]
        pieces = []
        for piece in ended:
            pieces.append((piece[: self._longest + 1], self._is_whole))
            self._is_whole = True
        return pieces


class FrameDecoder:
    """Decodes frames with a checksum; continues the board's u16 and u32 counts beyond their wraps and its restarts.

    Where the count breaks off, because the board began anew or was cut off for long, it goes on by our clock: then the
    frames that did not come are missing in `seq` and `t_device`, but are not counted as lost.
    """

    def __init__(self, channels: int, sample_rate: float) -> None:
        self.lost = self.junk = 0
        self.refusal: Text | None = None
        self.late_by = 0.0
        self._channels = channels
        self._sample_rate = sample_rate
        self._pieces = DelimitedPieces(b"\0", LONGEST_BODY + 1)
        self._lateness = Lateness(CLOCK_ERROR)
        self._seq = -1  # of the newest frame, as all of the following; -1: none yet
        self._microseconds = 0
        self._t = 0.0  # monotonic s
        self._board_seq = self._board_microseconds = 0

    def feed(self, content: bytes, t: float) -> list[SensorFrame]:
        """Return the frames that end in `content`, which came at `t` (monotonic s)."""
        frames = []
        for piece, is_whole in self._pieces.feed(content):
            decoded = decode_frame(piece)
            if decoded is not None and len(decoded[2]) == self._channels:
                frames.append(self._frame(decoded, t))
            elif piece and (is_whole or decoded is not None):
                self.junk += 1
                self.refusal = _refusal(piece, decoded, self._channels)
        return frames

    def begin_anew(self) -> None:
        """Expect the stream of a port that was opened again; the counts go on."""
        self._pieces.begin_anew()

    def _frame(self, decoded: BoardFrame, t: float) -> SensorFrame:
        seq, microseconds, values = decoded
        if self._seq < 0:
            self._seq, self._microseconds = seq, microseconds
        else:
            ahead = (seq - self._board_seq) % NUMBERS
            step = (microseconds - self._board_microseconds) % WRAP
            if 0 < step <= LONGEST_CUT and 0 < ahead <= 1 + step // SHORTEST_PERIOD:
                self.lost += ahead - 1
            else:
                ahead = max(1, round((t - self._t) * self._sample_rate))
                step = round(1e6 * ahead / self._sample_rate)
            self._seq += ahead
            self._microseconds += step
        self._board_seq, self._board_microseconds, self._t = seq, microseconds, t
        self.late_by = self._lateness.of(self._microseconds, t)
        return SensorFrame(self._seq % WRAP, 1e-6 * self._microseconds, t, values)


class LineDecoder:
    """Decodes lines of numbers. They carry no count and no time: both are those of the grid of the nominal rate.

    A pause moves on in the grid, so that a gap is no short time. The first line is left out, because its beginning may
    be missing; so is a line of words, such as a header.
    """

    def __init__(self, channels: int, sample_rate: float) -> None:
        self.lost = self.junk = 0
        self.refusal: Text | None = None
        self.late_by = 0.0
        self._channels = channels
        self._sample_rate = sample_rate
        self._pause = max(PAUSE, PAUSE_PERIODS / sample_rate)
        self._pieces = DelimitedPieces(b"\n", LONGEST_LINE)
        self._seq = -1  # of the newest line; -1: none yet
        self._t = math.nan  # when it came, monotonic s

    def feed(self, content: bytes, t: float) -> list[SensorFrame]:
        """Return the frames that end in `content`, which came at `t` (monotonic s)."""
        lines = [line for line, is_whole in self._pieces.feed(content) if is_whole and not is_text(line)]
        if not lines:
            return []
        pause = t - self._t
        if pause > self._pause:
            self._seq += max(0, round(pause * self._sample_rate) - len(lines))
        self._t = t
        frames = []
        for line in lines:
            self._seq += 1
            values = self._values(line)
            if values is not None:
                frames.append(SensorFrame(self._seq % WRAP, self._seq / self._sample_rate, t, values))
        return frames

    def begin_anew(self) -> None:
        """Expect the stream of a port that was opened again; the counts go on."""
        self._pieces.begin_anew()

    def _values(self, line: bytes) -> NDArray[np.float32] | None:
        """Return the values (n_channels,) of a line; count it and return None when it has not one for each channel."""
        numbers = numbers_in(line, self._channels)
        if numbers is not None and len(numbers) == self._channels:
            return np.array(numbers, dtype=np.float32)
        self.junk += 1
        self.lost += 1
        self.refusal = FOREIGN if numbers is None else _other_sensors(len(numbers), self._channels)
        return None


def decode_frame(piece: bytes) -> BoardFrame | None:
    """Return the frame in the bytes between two delimiters; None when they hold none, or a changed byte."""
    body = cobs_decoded(piece) if SHORTEST_BODY < len(piece) <= LONGEST_BODY + 1 else None
    if body is None or len(body) < SHORTEST_BODY or len(body) % 2:
        return None
    end = len(body) - CHECKSUM.size
    if crc_hqx(body[:end], CHECKSUM_START) != CHECKSUM.unpack_from(body, end)[0]:
        return None
    seq, microseconds = HEADER.unpack_from(body)
    steps = np.frombuffer(body, "<i2", (end - HEADER.size) // 2, HEADER.size)
    return seq, microseconds, np.where(steps == MISSING, np.float32(np.nan), steps.astype(np.float32))


def cobs_decoded(piece: bytes) -> bytes | None:
    """Return the bytes that were encoded as `piece`, which holds no zero; None when nothing is encoded like this.

    Source: Cheshire and Baker, Consistent Overhead Byte Stuffing, IEEE/ACM Transactions on Networking 7(2), 1999.
    """
    decoded, at = bytearray(), 0
    while at < len(piece):
        end = at + piece[at]
        if end > len(piece) or end == at:
            return None
        decoded += piece[at + 1 : end]
        if piece[at] < 0xFF and end < len(piece):
            decoded.append(0)
        at = end
    return bytes(decoded)


def numbers_in(line: bytes, channels: int) -> list[float] | None:
    """Return the numbers of a line, NaN where one is missing; None when it has other words.

    A separator behind the last of `channels` numbers separates nothing.
    """
    fields = _fields(line)
    if len(fields) == channels + 1 and not fields[-1]:
        fields.pop()
    numbers = []
    for field in fields:
        number = _number(field)
        if number is None:
            return None
        numbers.append(number)
    return numbers


def is_text(line: bytes) -> bool:
    """Return whether a line holds words only, as a header does, or nothing."""
    try:
        text = line.decode()
    except UnicodeDecodeError:
        return False
    words = [field for field in _fields(line) if field]
    if not words:
        return not text.strip(" \r")
    return text.replace("\t", "").rstrip("\r").isprintable() and all(_number(word) is None for word in words)


def _fields(line: bytes) -> list[bytes]:
    """Return what stands between the separators of a line, without blanks around it."""
    line = line.strip(b" \r")
    separator = next((one for one in SEPARATORS if one in line), None)
    return [field.strip() for field in line.split(separator)]


def _number(field: bytes) -> float | None:
    """Return the number of a field, NaN where it is missing; None for other words."""
    if NUMBER.fullmatch(field):
        value = float(field)
        return value if abs(value) <= LARGEST else math.nan
    return math.nan if NO_NUMBER.fullmatch(field) else None


def _refusal(piece: bytes, decoded: BoardFrame | None, channels: int) -> Text:
    """Return why a piece of the stream is no frame of `channels` channels."""
    if decoded is not None:
        return _other_sensors(len(decoded[2]), channels)
    return Text("shirtdev-frame-damaged") if len(piece) == HEADER.size + 2 * channels + CHECKSUM.size + 1 else FOREIGN


def _other_sensors(sent: int, expected: int) -> Text:
    return Text("shirtdev-frame-sensors", sent=sent, expected=expected)
