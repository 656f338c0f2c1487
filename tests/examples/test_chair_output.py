"""The example firmware of the analog output: compiled for this machine, it obeys the receiver, and nothing else."""

import random
import re
import struct
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

import pytest

from app.hardware.chair import analog
from app.hardware.chair.analog import BoardStatus, command_bytes, statuses
from app.hardware.chair.key import Key
from folders import ROOT
from needed import need

SKETCH = (ROOT / "examples" / "firmware" / "chair_output" / "chair_output.ino").read_text(encoding="utf-8")
STUB = Path(__file__).parent / "chair_board"
STRICT = ("-std=c++11", "-Wall", "-Wextra", "-Wconversion", "-Werror")
SECRET = bytes(range(100, 132))
KEY = Key(7, SECRET)
WITH_KEY = SKETCH.replace('KEY = "";', f'KEY = "{SECRET.hex()}";')
FORWARD, RIGHT = 0x60, 0x61  # the addresses of the converters
CENTRE, SWING = 2048, 819
STARTS = 41  # that the board's memory counts before
BOOT = STARTS + 1
PERIOD = 20  # ms between two statuses
SILENCE = 50  # ms after which the chair's inputs are at their centre
WAITING, STANDING, DRIVING, NO_KEY, BROKEN = range(5)


class Output(NamedTuple):
    """What the chair's interface gets."""

    relay: int
    forward: int  # steps
    right: int


AT_CENTRE = Output(0, CENTRE, CENTRE)


class Record(NamedTuple):
    """What a board did."""

    statuses: list[BoardStatus]
    events: list[tuple[int, str, int, int]]  # ms, what, number, a second number

    def output(self, t: int) -> Output:
        """Return what the chair's interface had at the end of the millisecond `t`."""
        found = {"relay": 0, FORWARD: -1, RIGHT: -1}
        for time, what, number, steps in self.events:
            if time <= t and what == "relay":
                found["relay"] = number
            elif time <= t and what == "dac":
                found[number] = steps
        return Output(found["relay"], found[FORWARD], found[RIGHT])

    def status(self, t: int) -> BoardStatus:
        """Return the newest status at `t` ms."""
        return [status for status in self.statuses if status.time <= t][-1]


Sent = Sequence[tuple[int, bytes]]


@pytest.fixture(scope="module")
def board(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Record]:
    """Return what compiles a sketch and runs it for so many ms, with what is sent to it when."""
    compiler = need("g++", "g++")
    programs: dict[str, Path] = {}

    def compiled(sketch: str) -> Path:
        folder = tmp_path_factory.mktemp("sketch")
        (folder / "sketch.ino").write_text(sketch, encoding="utf-8")
        command: list[str | Path] = [compiler, *STRICT, "-I", STUB, "-include", "Arduino.h", "-x", "c++"]
        command += [folder / "sketch.ino", STUB / "board.cpp", "-o", folder / "board"]
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
        assert done.returncode == 0, done.stderr
        return folder / "board"

    def run(sent: Sent, length: int = 1000, sketch: str = WITH_KEY, fails: tuple[int, int, int] = (0, 0, 0)) -> Record:
        if sketch not in programs:
            programs[sketch] = compiled(sketch)
        script = b"".join(struct.pack("<IB", t, len(content)) + content for t, content in sent)
        command = [str(programs[sketch]), str(STARTS), str(length), *map(str, fails)]
        done = subprocess.run(command, input=script, capture_output=True, check=True, timeout=60)
        rows = [line.split() for line in done.stderr.decode().splitlines()]
        events = [(int(row[0]), row[1], int(row[2]), int(row[3]) if len(row) > 3 else 0) for row in rows]
        return Record(statuses(bytearray(done.stdout)), events)

    return run


def answered(t: int) -> int:
    """Return the time (ms) of the newest status that a receiver has at `t` ms."""
    return (t - 1) // PERIOD * PERIOD


def command(t: int, number: int, forward: int = 0, right: int = 0, is_driven: bool = True, **changes: int) -> bytes:
    """Return the command of a receiver at `t` ms; `changes` replace fields of the status that it answers."""
    status = BoardStatus(0, 0, answered(t), BOOT)._replace(**changes)
    return command_bytes(KEY, is_driven, forward, right, number, status)


def stand(t: int, number: int) -> bytes:
    return command(t, number, is_driven=False)


def a_drive(until: int = 800, forward: int = 500, right: int = -250) -> list[tuple[int, bytes]]:
    """Return commands to stand, and from 101 ms on to drive, every 20 ms from 21 to `until` ms."""
    times = range(21, until + 1, PERIOD)
    return [
        (t, stand(t, number) if t < 101 else command(t, number, forward, right))
        for number, t in enumerate(times, start=1)
    ]


DRIVEN = Output(1, CENTRE + SWING // 2, CENTRE - SWING // 4)


def test_it_says_what_it_is_every_20_ms(board: Callable[..., Record]) -> None:
    record = board([])
    assert record.statuses == [BoardStatus(WAITING, 0, t, BOOT) for t in range(PERIOD, 1001, PERIOD)]
    assert (0, "baud", analog.BAUD, 0) in record.events


def test_at_its_start_the_relay_is_open_before_anything_else_and_the_voltages_are_at_their_centre(
    board: Callable[..., Record],
) -> None:
    record = board([], 10)
    assert record.events[:5] == [
        (0, "watchdog", 0, 0),
        (0, "relay", 0, 0),
        (0, "mode", 1, 0),
        (0, "relay", 0, 0),
        (0, "dac", FORWARD, CENTRE),
    ]
    assert record.output(0) == AT_CENTRE
    assert (0, "watchdog", 2, 0) in record.events, "60 ms"
    assert record.events[-1] == (10, "resets", 10, 0)


def test_it_drives_what_the_receiver_sends_and_says_which_command_it_obeyed(board: Callable[..., Record]) -> None:
    record = board(a_drive())
    assert record.output(100) == AT_CENTRE
    assert [record.output(t) for t in (101, 400, 820)] == [DRIVEN] * 3
    assert record.status(95) == BoardStatus(STANDING, 3, 80, BOOT)
    assert record.status(800) == BoardStatus(DRIVING, 39, 800, BOOT)


@pytest.mark.parametrize(
    ("per_mille", "steps"), [(1000, SWING), (-1000, -SWING), (1, 0), (2, 1), (-999, -818), (32_767, SWING)]
)
def test_deflections_become_voltages(board: Callable[..., Record], per_mille: int, steps: int) -> None:
    record = board(a_drive(200, per_mille, -per_mille if per_mille < 32_767 else -32_768), 190)
    assert record.output(190) == Output(1, CENTRE + steps, CENTRE - steps)


def test_the_other_polarity_is_a_constant(board: Callable[..., Record]) -> None:
    other = WITH_KEY.replace("FORWARD_IS_HIGHER = true", "FORWARD_IS_HIGHER = false")
    assert board(a_drive(200), 190, other).output(190) == Output(1, CENTRE - SWING // 2, CENTRE - SWING // 4)


def test_50_ms_after_the_last_command_it_stands_and_then_a_command_to_stand_comes_first(
    board: Callable[..., Record],
) -> None:
    drive = a_drive(401)
    last = drive[-1][0]
    goes_on = [(t, command(t, 100 + t, 500, -250)) for t in range(501, 601, PERIOD)]
    again = [(t, stand(t, 200 + t) if t < 651 else command(t, 200 + t, 500, -250)) for t in range(611, 700, PERIOD)]
    record = board([*drive, *goes_on, *again], 760)
    assert record.output(last + 44) == DRIVEN
    assert record.output(last + SILENCE) == AT_CENTRE
    assert record.status(500) == BoardStatus(WAITING, 0, 500, BOOT)
    assert record.output(610) == AT_CENTRE, "it drives on only after a command to stand"
    assert record.status(610).number == 0
    assert record.output(700) == DRIVEN


def test_every_bit_of_a_command_counts(board: Callable[..., Record]) -> None:
    forged = []
    for bit in range(8 * 38):
        t = 410 + bit
        content = bytearray(command(t, 1000 + bit, 900, 900))
        content[bit // 8] ^= 1 << bit % 8
        forged.append((t, bytes(content)))
    genuine = a_drive(800)
    record = board(sorted([*genuine, *forged], key=lambda each: each[0]))
    assert {record.output(t) for t in range(101, 820)} == {DRIVEN}
    assert record.status(800).number == len(genuine)


def test_what_is_old_repeated_foreign_or_cut_moves_nothing(board: Callable[..., Record]) -> None:
    rng = random.Random(5)
    genuine = a_drive(800)
    foreign: list[tuple[int, bytes]] = []
    for t in range(411, 790, 3):
        foreign.append((t, rng.choice(genuine[:15])[1]))  # recorded
        foreign.append((t, command(t, 5000, 900, 900, time=answered(t) - 120)))  # kept back
        foreign.append((t, command(t, 5000, 900, 900, time=answered(t) + 100)))  # not told yet
        foreign.append((t, command(t, 5000, 900, 900, boot=BOOT - 1)))  # of the start before
        status = BoardStatus(0, 0, answered(t), BOOT)
        foreign.append((t, command_bytes(Key(7, bytes(32)), True, 900, 900, 5000, status)))  # another chair's
        foreign.append((t, command(t, 5000, 900, 900)[: rng.randrange(38)]))  # cut
        foreign.append((t, rng.randbytes(rng.randrange(60))))
    record = board(sorted([*genuine, *foreign], key=lambda each: each[0]))
    outputs = {record.output(t) for t in range(101, 820)}
    assert outputs == {DRIVEN}
    assert record.status(800).number == len(genuine)


def test_a_command_that_comes_byte_by_byte_counts(board: Callable[..., Record]) -> None:
    pieces = [(t + i // 10, bytes([byte])) for t, content in a_drive(200) for i, byte in enumerate(content)]
    assert board(pieces, 190).output(190) == DRIVEN


def test_without_a_key_it_obeys_nothing(board: Callable[..., Record]) -> None:
    for sketch in (SKETCH, WITH_KEY.replace(SECRET.hex(), "g" * 64), WITH_KEY.replace(SECRET.hex(), "ab")):
        record = board(a_drive(300), 300, sketch)
        assert {record.output(t) for t in range(300)} == {AT_CENTRE}
        assert {status.state for status in record.statuses} == {NO_KEY}


@pytest.mark.parametrize("converter", [FORWARD, RIGHT])
def test_a_converter_that_does_not_answer_opens_the_relay_until_it_does(
    board: Callable[..., Record], converter: int
) -> None:
    record = board(a_drive(800), fails=(411, 600, converter))
    assert record.output(410) == DRIVEN
    assert {record.output(t).relay for t in range(425, 820)} == {0}
    assert record.status(500).state == BROKEN
    assert record.status(700).state == WAITING
    assert record.output(700) == AT_CENTRE
    assert any(what == "refused" for _, what, *_ in record.events)


def test_its_numbers_are_those_of_the_receiver_and_of_the_page() -> None:
    constants = {name: int(number) for name, number in re.findall(r"(\w+) = (\d+);", SKETCH)}
    assert constants["BAUD_RATE"] == analog.BAUD
    assert constants["VERSION"] == analog.VERSION
    assert constants["FULL"] == analog.PER_MILLE
    assert (constants["CENTRE"], constants["SWING"]) == (CENTRE, SWING)
    assert analog.EVERY * 1000 < constants["SILENCE"] < SILENCE
    assert set(analog.STATES) == {WAITING, STANDING, DRIVING, NO_KEY, BROKEN}
    page = (ROOT / "docs" / "chairs.md").read_text(encoding="utf-8")
    assert "Within 50 ms of the last command" in page
    assert f"`0x{FORWARD:x}`" in page
    assert f"`0x{RIGHT:x}`" in page
