"""The chair's receiver as a process that drives a WHILL over a serial line, with the standard library alone."""

import os
import signal
import subprocess
import sys

import pytest
from processes.chair_process import wait_until
from processes.strange_sender import PATIENCE, Receiver, StrangeSender

from app.hardware.chair.reasons import DESCRIPTIONS, Reason
from app.hardware.chair.whill_emulator import EmulatedWhillLine
from folders import ROOT


@pytest.fixture
def chair():
    made = EmulatedWhillLine()
    yield made
    made.close()


def test_it_drives_measures_and_gives_way_to_a_hand_on_the_chair_s_own_joystick(chair, tmp_path):
    options = ("--device", chair.device, "--tread", "0.5", "--backward-motor", "right")
    receiver = Receiver(tmp_path, *options, output="whill")
    sender = StrangeSender(receiver.port)
    try:
        for _ in range(10):  # a busy machine may stop the chair
            sender.arm()
            sender.drive(0.3, 0.2)
            sender.wait_for(lambda told: told[15] == pytest.approx(0.3, abs=0.002) or told[2] != 2)
            if sender.telemetry[-1][2] == 2:
                break
        assert sender.wait_for(lambda told: told[16] == pytest.approx(0.2, abs=0.01))[10] == pytest.approx(0.8)
        assert not chair.own_joystick_on
        chair.joystick = (40, 0)
        told = sender.wait_for(lambda told: told[2] == 3)
        assert (told[12], told[13]) == (Reason.OWN_JOYSTICK, 1)
        wait_until(lambda: chair.own_joystick_on and (chair.v, chair.omega) == (0.0, 0.0))
        chair.joystick = (0, 0)
        sender.wait_for(lambda told: (told[2], told[13]) == (0, 0))
        assert (chair.v, chair.omega) == (0.0, 0.0), "only a new arming drives"
        sender.arm()
        sender.drive(0.3)
        wait_until(lambda: chair.v > 0.2 or sender.telemetry[-1][2] == 0)
        assert receiver.end(signal.SIGTERM) == 0, receiver.words
        wait_until(lambda: chair.own_joystick_on and chair.v == 0.0)
    finally:
        sender.close()
        receiver.close()
    assert f"output: {DESCRIPTIONS[Reason.OWN_JOYSTICK]}" in receiver.words


def test_a_look_at_it_moves_nothing_and_says_what_it_found(chair, tmp_path):
    key = tmp_path / "1.key"
    key.touch(mode=0o600)
    key.write_text(f"1 {'0' * 64}\n")
    chair.error = 9
    command = [sys.executable, "-S", "-m", "app.hardware.chair.receive", "--check", "--key-file", str(key)]
    command += ["--output", "whill", "--device", chair.device, "--tread", "0.5"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    run = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=PATIENCE, check=False)
    assert run.returncode == 1
    found, trouble, last = run.stdout.splitlines()
    assert f"A WHILL on {chair.device}: on, battery 80 %, error code 9" in found
    assert (trouble, last) == (DESCRIPTIONS[Reason.CHAIR_ERROR], "Nothing was moved.")
    assert {payload[0] for _, payload in chair.commands} == {0}, "it only asked the chair to report"
