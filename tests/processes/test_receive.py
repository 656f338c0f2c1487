"""The chair's receiver as a process, commanded by an independent sender over a real socket.

How long something took is judged by the time stamps of the receiver's own lines and by when the sender sent, both of
one monotonic clock; what a busy machine adds is seen as a step that came late, and allowed for.
"""

import os
import signal
import socket
import subprocess
import sys
import time
from itertools import pairwise

import pytest
from processes.strange_sender import PATIENCE, Receiver, StrangeSender

from app.hardware.chair.reasons import DESCRIPTIONS, Reason
from folders import ROOT

CLOCK = getattr(time, "CLOCK_BOOTTIME", time.CLOCK_MONOTONIC)
STEP, TELL = 0.01, 0.1  # s


@pytest.fixture
def started(tmp_path):
    """Return a function that starts a receiver and connects a sender; both are ended with the test."""
    things = []

    def start(*options, **more):
        receiver = Receiver(tmp_path, *options, **more)
        things.append(receiver)
        sender = StrangeSender(receiver.port)
        things.append(sender)
        return receiver, sender

    yield start
    for thing in reversed(things):
        thing.close()


def armed_and_driving(receiver, sender, v=0.6):
    """Drive; arm again when a busy machine has disarmed the chair."""
    for _ in range(10):
        sender.arm()
        sender.drive(v)
        line = receiver.wait_for(lambda line: line["v"] > 0.999 * v or (line["v"] and line["state"] == "disarmed"))
        if line["state"] == "armed":
            return
        receiver.wait_for(lambda line: line["state"] == "disarmed" and not line["v"])
    raise AssertionError("the machine is too busy to drive")


def after(lines, t):
    return [line for line in lines if line["t"] > t]


def longest_pause(lines):
    """Return the largest lateness (s) of the receiver's steps: its lines come at least every 100 ms."""
    return max([0.0, *(b["t"] - a["t"] - TELL - STEP for a, b in pairwise(lines))])


def test_silence_slows_after_100_ms_and_disarms_after_300(started):
    receiver, sender = started()
    armed_and_driving(receiver, sender)
    offset = time.clock_gettime(CLOCK) - time.monotonic()
    sender.sending = False
    disarmed = receiver.wait_for(lambda line: line["state"] == "disarmed")
    last = sender.sent[-1][0] + offset
    lines = after(receiver.lines, last)
    late = longest_pause(lines) + 0.02  # the delay of the last datagram on a busy machine
    stood = next(index for index, line in enumerate(lines) if line["v"] == 0.0)
    slowed = next(b for a, b in reversed([*pairwise(lines[: stood + 1])]) if b["v"] < a["v"] and not a["v"] < 0.59)
    assert 0.09 <= slowed["t"] - last <= 0.11 + STEP + late
    assert 0.29 <= disarmed["t"] - last <= 0.31 + late
    assert lines[stood]["t"] - last <= 0.11 + 0.25 + late
    assert disarmed["reason"] == DESCRIPTIONS[Reason.SILENT]
    told = sender.wait_for(lambda told: told[2] == 0)
    assert told[12] == 1


def test_the_stop_flag_stops_at_once_and_a_new_arming_drives_again(started):
    receiver, sender = started()
    armed_and_driving(receiver, sender)
    sender.v, sender.flags = 0.0, 2
    line = receiver.wait_for(lambda line: line["state"] == "disarmed")
    assert line["reason"] == DESCRIPTIONS[Reason.STOP_COMMAND]
    receiver.wait_for(lambda line: line["state"] == "disarmed" and line["v"] == 0.0)
    falling = [line["v"] for line in [line, *after(receiver.lines, line["t"])]]
    assert falling[0] > 0.4
    assert falling == sorted(falling, reverse=True)
    old = next(told[7] for told in sender.telemetry if told[2] == 2)
    assert sender.wait_for(lambda told: told[2] == 0 and told[12] == 2)[7] != old
    sender.sending = False
    armed_and_driving(receiver, sender, 0.3)


def test_a_recorded_drive_moves_neither_this_chair_nor_the_one_that_is_started_again(started):
    receiver, sender = started()
    armed_and_driving(receiver, sender)
    sender.flags = 2
    receiver.wait_for(lambda line: line["state"] == "disarmed" and line["v"] == 0.0)
    sender.sending = False
    recording = [datagram for _, datagram in sender.sent]
    began = receiver.lines[-1]["t"]
    again, other = started()
    for datagram in recording:
        sender.socket.send(datagram)
        other.socket.send(datagram)
        time.sleep(0.002)
    seen = time.clock_gettime(CLOCK)
    for chair in (receiver, again):
        chair.wait_for(lambda line: line["t"] > seen)
    assert {(line["state"], line["v"]) for line in after(receiver.lines, began)} == {("disarmed", 0.0)}
    assert {(line["state"], line["v"], line["omega"], line["reason"]) for line in again.lines} == {
        ("disarmed", 0.0, 0.0, "")
    }


def test_a_receiver_that_was_held_up_finds_itself_disarmed(started):
    receiver, sender = started()
    armed_and_driving(receiver, sender)
    receiver.process.send_signal(signal.SIGSTOP)
    time.sleep(0.5)
    held = time.clock_gettime(CLOCK)
    receiver.process.send_signal(signal.SIGCONT)
    line = receiver.wait_for(lambda line: line["t"] > held)
    assert line["state"] == "disarmed"
    assert line["reason"] == DESCRIPTIONS[Reason.LATE]
    receiver.wait_for(lambda line: line["t"] > held and line["v"] == 0.0)
    assert all(line["v"] <= 0.6 for line in after(receiver.lines, held))


@pytest.fixture
def hang_up_is_heard():
    """Let processes end on SIGHUP, also when `nohup` started the tests."""
    before = signal.signal(signal.SIGHUP, signal.SIG_DFL)
    yield
    signal.signal(signal.SIGHUP, before)


@pytest.mark.usefixtures("hang_up_is_heard")
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT, signal.SIGHUP])
def test_ended_while_it_moves_it_ramps_says_so_and_leaves(started, number):
    receiver, sender = started()
    armed_and_driving(receiver, sender)
    heard = len(sender.telemetry)
    assert receiver.end(number) == 0
    ending = [line for line in receiver.lines if line["reason"] == DESCRIPTIONS[Reason.ENDING]]
    assert {line["state"] for line in ending} == {"disarmed"}
    assert ending[0]["v"] > 0.4
    assert ending[-1]["v"] == 0.0
    assert all(a["v"] >= b["v"] for a, b in pairwise(ending))
    told = sender.wait_for(lambda told: len(sender.telemetry) > heard and told[8] == 0.0)
    assert (told[2], told[12]) == (0, 8)


def test_its_own_switch_stops_it_and_a_missing_file_is_a_pressed_switch(started, tmp_path):
    switch, battery = tmp_path / "switch", tmp_path / "battery"
    battery.write_text("0.5\n")
    receiver, sender = started("--stop-input", str(switch), "--battery-input", str(battery))
    receiver.wait_for(lambda line: line["state"] == "fault")
    switch.write_text("0\n")
    receiver.wait_for(lambda line: line["state"] == "disarmed")
    armed_and_driving(receiver, sender)
    assert sender.telemetry[-1][10:12] == (0.5, 0)
    switch.write_text("1\n")
    line = receiver.wait_for(lambda line: line["state"] == "fault")
    assert line["reason"] == DESCRIPTIONS[Reason.STOP_INPUT]
    assert sender.wait_for(lambda told: told[2] == 3)[11:13] == (1, 4)
    receiver.wait_for(lambda line: line["state"] == "fault" and line["v"] == 0.0)
    switch.write_text("0\n")
    receiver.wait_for(lambda line: line["state"] == "disarmed")


def test_a_reader_who_does_not_read_does_not_hold_up_the_watch(started):
    receiver, sender = started()
    sender.arm()
    receiver.stop_reading()
    for v in (0.2, 0.8) * 8:  # each way of 0.2 s is more than twenty lines of 80 bytes, and the pipe holds a page
        sender.drive(v)
        sender.wait_for(lambda told, v=v: told[8] == pytest.approx(v))
    sender.sending = False
    assert sender.wait_for(lambda told: told[2] == 0)[12] == 1
    receiver.read_on()
    receiver.wait_for(lambda line: line["reason"])


def test_a_reader_who_leaves_ends_it_in_order(started):
    receiver, sender = started()
    armed_and_driving(receiver, sender)
    handle = receiver.process.stdout.fileno()
    silent = os.open(os.devnull, os.O_RDONLY)
    os.dup2(silent, handle)  # the pipe has no reader any more
    os.close(silent)
    assert receiver.process.wait(PATIENCE) == 0
    told = sender.wait_for(lambda told: told[8] == 0.0)
    assert (told[2], told[12]) == (3, 7)


def test_nothing_but_the_standard_library_is_loaded(tmp_path):
    code = (
        "import sys, app.hardware.chair.receive\n"
        "known = {*sys.stdlib_module_names, 'app', '__main__'}\n"
        "print([name for name in sys.modules if name.split('.')[0] not in known])"
    )
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    run = subprocess.run(
        [sys.executable, "-S", "-c", code], capture_output=True, text=True, env=environment, cwd=tmp_path, check=True
    )
    assert run.stdout.strip() == "[]"


def test_the_simulated_drive_says_where_it_is(started):
    receiver, sender = started(output="sim")
    sender.arm()
    sender.drive(0.5)
    line = receiver.wait_for(lambda line: line.startswith("armed: wheels at 0.50"))
    assert "heading 0 degrees" in line
    assert receiver.end(signal.SIGTERM) == 0


def test_hellos_are_answered_and_grant_nothing(started):
    receiver, sender = started()
    sender.hello()
    assert sender.wait_for(lambda _: True)[2:6] == (0, 513, 0, 0)
    stranger = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    with stranger:
        stranger.connect(("127.0.0.1", receiver.port))
        stranger.settimeout(0.3)
        stranger.send(b"BMIH\x01\x00\x02\x03\x00\x00\x00\x00")  # 0x0302 = 770, another chair's number
        with pytest.raises(TimeoutError):
            stranger.recv(100)


REFUSED = {
    ("--v-max", "9"): "--v-max",
    ("--v-max", "nan"): "--v-max",
    ("--v-max", "0"): "--v-max",
    ("--omega-max", "2.6"): "--omega-max",
    ("--port", "65536"): "65536",
    ("--bind", "no.such.host.invalid"): "no.such.host.invalid",
    ("--paired", "nowhere"): "HOST:PORT",
    ("--output", "can"): "can",
    ("--tread", "0.5"): "does not take --tread",
    ("--output", "whill"): "needs --device",
    ("--output", "whill", "--device", "/dev/none", "--tread", "0.5"): "/dev/none",
    ("--output", "whill", "--device", "/dev/none", "--tread", "nan"): "'nan' is no tread",
    ("--output", "whill", "--device", "/dev/none", "--check"): "needs --tread",
    ("--output", "analog", "--device", "/dev/none"): "/dev/none",
    ("--output", "analog", "--device", "/dev/none", "--chair-document", "none"): "the chair document none",
    ("--output", "luci"): "bodydrive[ros2]",
    ("--message", "Odometry"): "Odometry",
    ("--backward-motor", "both"): "both",
    ("--stop",): "--stop",
}


@pytest.mark.parametrize("options", REFUSED, ids=" ".join)
def test_what_cannot_be_is_refused_in_one_sentence(options, tmp_path):
    key = tmp_path / "key"
    key.touch(mode=0o600)
    key.write_text(f"1 {'0' * 64}\n")
    said = refused(tmp_path, "--key-file", str(key), "--output", "stdout", "--port", "0", *options)
    assert REFUSED[options] in said


def test_a_look_at_an_output_without_a_chair_says_so_and_moves_nothing(tmp_path):
    key = tmp_path / "key"
    key.touch(mode=0o600)
    key.write_text(f"1 {'0' * 64}\n")
    command = [sys.executable, "-S", "-m", "app.hardware.chair.receive", "--key-file", str(key), "--output", "sim"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    run = subprocess.run(
        [*command, "--check"],
        capture_output=True,
        text=True,
        env=environment,
        cwd=tmp_path,
        check=True,
        timeout=PATIENCE,
    )
    assert run.stdout.splitlines() == [
        "A simulated drive: no chair is connected, so there is nothing to look at.",
        "It can be driven.",
        "Nothing was moved.",
    ]
    assert run.stderr == ""


def test_an_unreadable_key_and_a_busy_port_are_refused(tmp_path):
    key = tmp_path / "key"
    assert "cannot be read" in refused(tmp_path, "--key-file", str(key), "--output", "stdout")
    key.touch(mode=0o644)
    key.write_text(f"1 {'0' * 64}\n")
    assert "chmod 600" in refused(tmp_path, "--key-file", str(key), "--output", "stdout")
    key.chmod(0o600)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as busy:
        busy.bind(("127.0.0.1", 0))
        port = str(busy.getsockname()[1])
        assert port in refused(tmp_path, "--key-file", str(key), "--output", "stdout", "--port", port)
    said = refused(tmp_path, "--key-file", str(key), "--output", "ros2", "--port", "0")
    assert "bodydrive[ros2]" in said  # -S: no library is there


def refused(folder, *options):
    run = subprocess.run(
        [sys.executable, "-S", "-m", "app.hardware.chair.receive", *options],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        cwd=folder,
        timeout=PATIENCE,
        check=False,
    )
    assert run.returncode == 2
    assert run.stdout == ""
    assert run.stderr.count("\n") == 1
    assert str(bytes(32).hex()) not in run.stderr
    return run.stderr
