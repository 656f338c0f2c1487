"""The example firmware of a shirt on a cable: compiled for this machine, it sends what the decoders read."""

import re
import struct
import subprocess
from binascii import crc_hqx
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import pytest
from hardware.shirt.wired_board import frame_bytes

from app.hardware.shirt.serial_bytes import FrameDecoder, LineDecoder, cobs_decoded
from app.hardware.shirt.serial_line import SerialConfig
from app.layout import ShirtLayout
from folders import ROOT
from needed import need

FOLDER = ROOT / "examples" / "firmware" / "wired_shirt"
SKETCH = (FOLDER / "wired_shirt.ino").read_text(encoding="utf-8")
LAYOUT = ShirtLayout.model_validate_json((FOLDER / "wired_shirt.layout.json").read_bytes())
STUB = Path(__file__).parent / "arduino"
SENSORS, READINGS, FIRST_PIN = 6, 8, 14
LOOP, PERIOD = 2_500, 10_000  # microseconds
FRAMES = 200
PLAIN = SKETCH.replace("const bool PLAIN_LINES = false;", "const bool PLAIN_LINES = true;")
STRICT = ("-std=c++11", "-Wall", "-Wextra", "-Wconversion", "-Werror")


class Sent(NamedTuple):
    """What a board has sent, and what it was asked meanwhile."""

    content: bytes
    baud: int
    pins: list[int]  # of all readings
    sums: list[list[int]]  # (FRAMES, SENSORS)


@pytest.fixture(scope="module")
def board(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Sent]:
    """Return what compiles a sketch and runs it for FRAMES frames."""
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

    def run(sketch: str, start: int = 0) -> Sent:
        if sketch not in programs:
            programs[sketch] = compiled(sketch)
        loops = FRAMES * PERIOD // LOOP
        command = [str(programs[sketch]), str(start), str(LOOP), str(loops)]
        done = subprocess.run(command, capture_output=True, check=True, timeout=60)
        first, *rows = done.stderr.decode().splitlines()
        pins, readings = zip(*(map(int, row.split()) for row in rows), strict=True)
        sums = [sum(readings[i : i + READINGS]) for i in range(0, len(readings), READINGS)]
        frames = [sums[i : i + SENSORS] for i in range(0, len(sums), SENSORS)]
        return Sent(done.stdout, int(first.removeprefix("baud ")), list(pins), frames)

    return run


def test_the_bytes_are_those_of_the_protocol_one_by_one(board: Callable[..., Sent]) -> None:
    sent = board(SKETCH)
    assert len(sent.sums) == FRAMES
    expected = [frame_bytes(i, PERIOD * (i + 1), values) for i, values in enumerate(sent.sums)]
    assert sent.content == b"\0" + b"".join(expected)
    body = cobs_decoded(sent.content[1 : sent.content.index(0, 1)])
    assert body is not None
    assert struct.unpack("<HI6hH", body) == (0, PERIOD, *sent.sums[0], crc_hqx(body[:-2], 0xFFFF))


@pytest.mark.parametrize("start", [0, 2**32 - 50 * PERIOD - 7])
def test_the_decoder_reads_each_frame_also_where_the_clock_wraps(board: Callable[..., Sent], start: int) -> None:
    sent = board(SKETCH, start)
    decoder = FrameDecoder(SENSORS, 1e6 / PERIOD)
    frames = decoder.feed(sent.content, 1.0)
    assert (len(frames), decoder.lost, decoder.junk) == (FRAMES, 0, 0)
    assert [frame.seq for frame in frames] == list(range(FRAMES))
    assert [frame.values.tolist() for frame in frames] == sent.sums
    times = [1e-6 * (start + PERIOD * (i + 1)) for i in range(FRAMES)]
    assert [frame.t_device - times[0] for frame in frames] == pytest.approx([t - times[0] for t in times])


def test_the_constant_at_the_top_selects_lines_which_have_the_same_values(board: Callable[..., Sent]) -> None:
    assert PLAIN != SKETCH
    sent = board(PLAIN)
    header, *lines, end = sent.content.decode().split("\r\n")
    assert (header, end) == (",".join(f"sensor_{i}" for i in range(1, SENSORS + 1)), "")
    assert lines == [",".join(map(str, values)) for values in sent.sums]
    decoder = LineDecoder(SENSORS, 1e6 / PERIOD)
    frames = decoder.feed(sent.content, 1.0)
    assert [frame.values.tolist() for frame in frames] == sent.sums
    assert (decoder.lost, decoder.junk) == (0, 0)


def test_each_sensor_is_read_at_its_own_input_and_no_sum_is_too_large(board: Callable[..., Sent]) -> None:
    sent = board(SKETCH)
    one_frame = [FIRST_PIN + sensor for sensor in range(SENSORS) for _ in range(READINGS)]
    assert sent.pins == FRAMES * one_frame
    assert READINGS * 4095 <= 32_767


def test_a_board_that_is_too_slow_makes_up_for_nothing(board: Callable[..., Sent]) -> None:
    slow = SKETCH.replace("FRAMES_PER_SECOND = 100", "FRAMES_PER_SECOND = 1000")
    content = board(slow).content  # a loop takes 2.5 ms, a frame 1 ms
    frames = FrameDecoder(SENSORS, 400.0).feed(content, 1.0)
    assert len(frames) == FRAMES * PERIOD // LOOP
    assert frames[-1].t_device == pytest.approx(1e-6 * FRAMES * PERIOD)


def test_layout_rate_and_speed_fit_the_page_s_own(board: Callable[..., Sent]) -> None:
    pins = re.findall(r"\bA\d\b", SKETCH.split("SENSOR_PINS[] = {")[1].split("}")[0])
    assert len(pins) == len(LAYOUT.channels) == SENSORS
    config = SerialConfig(kind="serial")
    assert board(SKETCH).baud == config.baud
    page = (ROOT / "docs" / "hardware.md").read_text(encoding="utf-8")
    assert re.findall(r"^\| (A\d) \|.*\| `(\w+)` \|$", page, re.MULTILINE) == [
        (pin, channel.name) for pin, channel in zip(pins, LAYOUT.channels, strict=True)
    ]
    assert f"FRAMES_PER_SECOND = {config.sample_rate:.0f};" in SKETCH
    assert config.format == "frames"
