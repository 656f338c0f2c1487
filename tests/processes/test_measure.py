"""`bodydrive chair measure` as a process, in a terminal, with a board at the end of a serial line and its page."""

import json
import os
import pty
import subprocess
import sys
import time
import urllib.request

import pytest
from drills.far_chairs import BoardEnd
from processes.chair_process import PATIENCE, wait_until
from processes.served_demo import free_port

from app.hardware.chair.chair_document import joystick_table
from app.hardware.chair.key import new_key, write_key
from folders import ROOT

TRIES = 10


class MeasurementProcess:
    """The program, the terminal that it was started in, and its board."""

    def __init__(self, folder):
        key = new_key(7)
        write_key(folder / "7.key", key)
        self.board, self.out = BoardEnd(key.secret), folder / "chair.json"
        self._far, near = pty.openpty()
        command = [sys.executable, "-S", "-m", "app.hardware.chair.chair_measure", "--output", "analog"]
        place = f"127.0.0.1:{free_port()}"
        command += ["--key-file", folder / "7.key", *self.board.options, "--out", self.out, "--page", place]
        environment = {**os.environ, "PYTHONPATH": str(ROOT)}
        self.process = subprocess.Popen(command, stdin=near, stdout=subprocess.PIPE, text=True, env=environment)
        os.close(near)
        self.page = f"http://{place}/"
        assert any(self.page in line for line in self.process.stdout)

    def press(self, keys):
        os.write(self._far, keys)

    def now(self):
        with urllib.request.urlopen(f"{self.page}state", timeout=PATIENCE) as answer:
            return json.load(answer)["headline"]

    def stop(self):
        urllib.request.urlopen(f"{self.page}stop", data=b"", timeout=PATIENCE).close()

    def drive(self):
        """Begin a drive; a busy machine may end it at once."""
        for _ in range(TRIES):
            wait_until(lambda: self.now() == "IT STANDS")
            self.press(b"\n")
            until = time.monotonic() + 2.0
            while time.monotonic() < until:
                if self.board.deflection != (0, 0):
                    return
                time.sleep(0.005)
        raise AssertionError("it never drove")

    def measure(self, line):
        """Drive, end that by a key, and type what was measured."""
        for _ in range(TRIES):
            self.drive()
            self.press(b" ")
            wait_until(lambda: self.now() in ("IT STOPS", "IT STANDS"))
            if self.now() == "IT STOPS":
                wait_until(self.stands)
                self.press(line)
                return
        raise AssertionError("no drive was ended by a key")

    def stands(self):
        return self.board.deflection == (0, 0) and not self.board.relay_closed

    def close(self):
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()
        os.close(self._far)
        self.board.close()


@pytest.fixture
def measuring(tmp_path):
    made = MeasurementProcess(tmp_path)
    yield made
    made.close()


@pytest.mark.long
def test_three_drives_make_a_document_and_the_page_stops_one(measuring):
    measuring.drive()
    measuring.stop()
    wait_until(measuring.stands)
    for line in (b"3 6\n", b"3 6\n", b"280 6\n"):
        measuring.measure(line)
    assert measuring.process.wait(PATIENCE) == 0
    assert joystick_table(measuring.out).most.v == 0.5
    assert measuring.stands()


@pytest.mark.long
def test_killed_while_it_drives_the_board_lets_the_joystick_go(measuring):
    measuring.drive()
    measuring.process.kill()
    wait_until(measuring.stands)
    assert not measuring.out.exists()
