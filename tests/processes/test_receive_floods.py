"""The chair's receiver on a flooded port: it drives on, keeps its limits, and answers no more than it should."""

import random
import socket
import struct
import subprocess
import sys
import time

import pytest
from processes.strange_sender import KEY_ID, Receiver, StrangeSender

RATE = 50_000  # datagrams a second
SECONDS = 1.0
ATTEMPTS = 8  # a busy machine may delay the sender itself
HELLO = struct.pack("<4sBBHI", b"BMIH", 1, 0, KEY_ID, 0)
JUNK = {
    "of another length": b"\x00" * 40,
    "that looks like a command": b"BMIW\x01\x01" + struct.pack("<H", KEY_ID) + random.Random(1).randbytes(60),
    "hellos": HELLO,
}
FLOOD = f"""
import socket, sys, time
out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
out.connect(("127.0.0.1", int(sys.argv[1])))
datagram, sent, began = bytes.fromhex(sys.argv[2]), 0, time.monotonic()
while True:
    time.sleep(0.001)
    while sent < {RATE} * (time.monotonic() - began):
        try:
            out.send(datagram)
        except OSError:
            pass
        sent += 1
"""


@pytest.fixture
def chair(tmp_path):
    receiver = Receiver(tmp_path)
    sender = StrangeSender(receiver.port)
    yield receiver, sender
    sender.close()
    receiver.close()


@pytest.fixture
def flood(chair):
    """Return a function that floods the receiver's port with a datagram, until the test ends."""
    started = []

    def begin(datagram):
        command = [sys.executable, "-S", "-c", FLOOD, str(chair[0].port), datagram.hex()]
        started.append(subprocess.Popen(command))

    yield begin
    for process in started:
        process.kill()
        process.wait()


def drives_through(receiver, sender):
    """Drive for a while; return whether every line reports the drive."""
    sender.arm()
    receiver.lines.clear()
    sender.drive(0.5)
    receiver.wait_for(lambda line: line["v"] == 0.5 or line["state"] == "disarmed")
    receiver.lines.clear()
    time.sleep(SECONDS)
    said = list(receiver.lines)
    sender.sending = False
    receiver.lines.clear()
    receiver.wait_for(lambda line: line["state"] == "disarmed" and line["v"] == 0.0)
    return len(said) >= 0.5 * SECONDS / 0.1 and all((line["state"], line["v"]) == ("armed", 0.5) for line in said)


@pytest.mark.parametrize("kind", JUNK)
def test_fifty_thousand_datagrams_a_second_do_not_stop_the_drive(chair, flood, kind):
    receiver, sender = chair
    flood(JUNK[kind])
    assert any(drives_through(receiver, sender) for _ in range(ATTEMPTS)), receiver.lines[-3:]


def test_a_flood_does_not_keep_the_watch_from_stopping_the_chair(chair, flood):
    receiver, sender = chair
    sender.arm()
    sender.drive(0.5)
    receiver.wait_for(lambda line: line["v"] == 0.5)
    flood(JUNK["that looks like a command"])
    sender.sending = False
    line = receiver.wait_for(lambda line: line["state"] == "disarmed")
    assert line["reason"]
    receiver.wait_for(lambda line: line["state"] == "disarmed" and line["v"] == 0.0)


def test_a_flood_of_hellos_is_answered_fifty_times_a_second_at_most(chair):
    receiver, _ = chair
    times = []
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as greedy:
        greedy.connect(("127.0.0.1", receiver.port))
        greedy.settimeout(0.001)
        until = time.monotonic() + SECONDS
        while time.monotonic() < until:
            greedy.send(HELLO)
            try:
                times.append(struct.unpack_from("<Q", greedy.recv(100), 20)[0] * 1e-9)
            except TimeoutError:
                continue
    assert len(times) > 5
    lasted = times[-1] - times[0]  # s of the receiver's own time
    assert len(times) <= lasted / 0.02 + lasted / 0.1 + 3, "an answer each 20 ms, and what is told at rest each 100 ms"
