"""The rows of the real chair with short runs of real processes; the tests check counts, not speed."""

import json
import socket
import subprocess

from app.clock import MonotonicClock
from app.hardware.chair.key import new_key
from app.hardware.chair.packet import (
    DRIVE,
    FRAME_BYTES,
    STOP,
    TELEMETRY_BYTES,
    ChairCommand,
    decode_command,
    decode_telemetry,
    encode_command,
    encode_hello,
)
from bench.children import module
from bench.period import measure_period
from bench.processes.junk import KEY_ID
from bench.processes.measured_chair import MeasuredChair
from bench.turn import PARTS, measure_turn
from bench.web.stop import measure_stop


def test_junk_looks_like_frames_is_none_and_is_counted() -> None:
    key = new_key(KEY_ID)
    with (
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as ours,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as source,
    ):
        ours.bind(("127.0.0.1", 0))
        ours.settimeout(5.0)
        port, descriptor = ours.getsockname()[1], source.fileno()
        asked = ["200", "0.5", f"{port}:W:{descriptor}", f"{port}:T:{descriptor}"]
        told = subprocess.run(
            [*module("bench.processes.junk"), *asked], pass_fds=[descriptor], capture_output=True, text=True, check=True
        )
        flood = json.loads(told.stdout)
        assert flood["sent"] == [100, 100]
        assert flood["end"] - flood["begin"] > 0.2
        datagrams = [ours.recv(2000) for _ in range(200)]
    assert {(datagram[:4], len(datagram)) for datagram in datagrams} == {
        (b"BMIW", FRAME_BYTES),
        (b"BMIT", TELEMETRY_BYTES),
    }
    assert not any(decode_command(datagram, key, bytes(8)) for datagram in datagrams)
    assert not any(decode_telemetry(datagram, key) for datagram in datagrams)


def test_a_stop_is_measured_from_its_command_to_its_frame() -> None:
    rows = measure_stop(runs=1, stops=2)
    assert [row.unit for row in rows] == ["ms", "ms"]
    assert all(0.0 < row.figure < 2000.0 for row in rows)
    assert all("2 stops" in row.details for row in rows)


def test_the_command_period_is_measured_while_the_chair_drives_under_junk() -> None:
    p99, longest = measure_period(seconds=3.0, rate=2000.0, runs=1)
    assert 5.0 < p99.figure <= longest.figure
    assert "/s to the chair's port" in p99.details
    assert 10 < int(p99.details.split()[0]) < 200  # two seconds of them


KEY = new_key(1)
PATIENCE = 20.0  # s


def test_it_answers_a_hello_and_notes_the_commands_that_it_accepts() -> None:
    clock = MonotonicClock()
    with MeasuredChair(KEY) as chair, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        sender.settimeout(PATIENCE)
        sender.connect(("127.0.0.1", chair.port))
        sender.send(encode_hello(1))
        telemetry = decode_telemetry(sender.recv(TELEMETRY_BYTES), KEY)
        assert telemetry is not None
        before = clock.now()

        def send(sequence: int, flags: int, v: float = 0.0) -> None:
            command = ChairCommand(flags, 1, 7, sequence, sequence, v, 0.0, 1.0, 1.0, bytes(8))
            sender.send(encode_command(command, KEY, telemetry.nonce))

        def wait_for(count: int) -> None:
            until = clock.now() + PATIENCE
            while len(chair.commands) < count and clock.now() < until:
                clock.sleep_until(clock.now() + 0.01)

        send(1, DRIVE, 0.5)  # refused: an epoch begins with a command to stand
        send(1, 0)
        wait_for(1)
        when, command = chair.commands[0]
        assert before <= when <= clock.now()
        assert (command.epoch, command.sequence) == (7, 1)
        send(2, STOP)  # noted although it makes a new nonce
        wait_for(2)
        assert [noted.flags for _, noted in chair.commands] == [0, STOP]


def test_every_part_of_a_turn_is_measured() -> None:
    rows = measure_turn(runs=1, frames=200, echoes=20)
    assert [row.what.partition(": ")[2] for row in rows] == list(PARTS.values())
    assert all(row.figure >= 0.0 for row in rows)
    assert sum(row.figure > 0.0 for row in rows) >= len(rows) - 1  # a busy machine may have no waking to see
