"""The chair of the benchmark: a real receiver on a socket, which notes the accepted commands."""

import socket

from app.clock import MonotonicClock
from app.hardware.chair.key import new_key
from app.hardware.chair.packet import (
    DRIVE,
    FRAME_BYTES,
    STOP,
    ChairCommand,
    decode_telemetry,
    encode_command,
    encode_hello,
)
from bench.processes.measured_chair import MeasuredChair

KEY = new_key(1)
PATIENCE = 20.0  # s


def test_it_answers_a_hello_and_notes_the_commands_that_it_accepts() -> None:
    clock = MonotonicClock()
    with MeasuredChair(KEY) as chair, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        sender.settimeout(PATIENCE)
        sender.connect(("127.0.0.1", chair.port))
        sender.send(encode_hello(1))
        telemetry = decode_telemetry(sender.recv(FRAME_BYTES), KEY)
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
