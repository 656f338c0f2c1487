"""A sender written from safety.md alone, by somebody who never saw this project's code: struct, hmac, a socket."""

import fcntl
import hashlib
import hmac
import os
import random
import socket
import struct
import threading
import time
from contextlib import suppress
from pathlib import Path

from processes.chair_process import Receiving

from folders import ROOT

PATIENCE = 60.0  # s
COMMAND, TELEMETRY = struct.Struct("<4sBBHIQQffff8s"), struct.Struct("<4sBBHIQQ8sfffBBBBff8s")
KEY_ID, SECRET = 513, bytes(range(100, 132))


class StrangeSender:
    """Commands a receiver at 50 Hz from a thread, so that a busy test does not delay the commands."""

    def __init__(self, port):
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.connect(("127.0.0.1", port))
        self.socket.settimeout(0.005)
        self.sent = []  # (monotonic s, datagram)
        self.telemetry = []  # telemetries with a valid tag, unpacked, newest last
        self.flags, self.v, self.omega = 0, 0.0, 0.0
        self.sending = False
        self._epoch, self._sequence = 0, 0
        self._ending = False
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    @property
    def nonce(self):
        return self.telemetry[-1][7]

    def hello(self):
        self.socket.send(struct.pack("<4sBBHI", b"BMIH", 1, 0, KEY_ID, 0))

    def wait_for(self, condition):
        """Wait for a telemetry that fulfils the condition, and return it."""
        until = time.monotonic() + PATIENCE
        while time.monotonic() < until:
            if self.telemetry and condition(self.telemetry[-1]):
                return self.telemetry[-1]
            time.sleep(0.005)
        raise AssertionError(f"the chair did not say so: {self.telemetry[-3:]}")

    def arm(self):
        """Begin a new epoch and wait until the chair is armed; repeat that on a busy machine."""
        for _ in range(10):
            while not self.telemetry:
                self.hello()
                time.sleep(0.05)
            self.flags, self.v, self.omega = 0, 0.0, 0.0
            self._epoch = random.getrandbits(32)
            self.sending = True
            told = self.wait_for(lambda told: told[4] == self._epoch and told[2] in (0, 2))
            if told[2] == 2:
                return
        raise AssertionError("the chair was never armed")

    def drive(self, v, omega=0.0):
        self.v, self.omega, self.flags = v, omega, 1

    def frame(self):
        self._sequence += 1
        fields = (KEY_ID, self._epoch, self._sequence, time.monotonic_ns(), self.v, self.omega, 1.5, 2.5, b"12345678")
        body = COMMAND.pack(b"BMIW", 1, self.flags, *fields)
        return body + hmac.new(SECRET, body + self.nonce, hashlib.sha256).digest()[:16]

    def close(self):
        self._ending = True
        self._thread.join()
        self.socket.close()

    def _run(self):
        due = 0.0
        while not self._ending:
            with suppress(OSError):  # no datagram, or no listener
                self._hear(self.socket.recv(100))
            if self.sending and time.monotonic() >= due:
                due = time.monotonic() + 0.018
                datagram = self.frame()
                self.sent.append((time.monotonic(), datagram))
                with suppress(OSError):
                    self.socket.send(datagram)

    def _hear(self, datagram):
        if len(datagram) != 84 or datagram[:5] != b"BMIT\x02":
            return
        if hmac.new(SECRET, datagram[:68], hashlib.sha256).digest()[:16] == datagram[68:]:
            self.telemetry.append(TELEMETRY.unpack(datagram[:68]))


class Receiver(Receiving):
    """The receiver as a process, whose key is the one of this sender."""

    def __init__(self, folder, *options, output="stdout", interpreter=("-S",), environment=None):
        self.key_file = Path(folder) / "513.key"
        if not self.key_file.exists():
            self.key_file.touch(mode=0o600)
            self.key_file.write_text(f"{KEY_ID} {SECRET.hex()}\n")
        self._deaf = threading.Event()
        self._looked_at = 0
        more = {"cwd": folder, "env": {**os.environ, "PYTHONPATH": str(ROOT), **(environment or {})}}
        super().__init__(self.key_file, "--port", "0", *options, output=output, interpreter=interpreter, **more)

    def _pause(self):
        while self._deaf.is_set():
            time.sleep(0.01)

    def stop_reading(self):
        """Stop reading its lines, so that the pipe fills."""
        self._deaf.set()
        fcntl.fcntl(self.process.stdout, fcntl.F_SETPIPE_SZ, 4096)

    def read_on(self):
        self._deaf.clear()

    def wait_for(self, condition):
        """Return the next line that fulfils the condition, after the last line returned."""
        until = time.monotonic() + PATIENCE
        while time.monotonic() < until:
            while self._looked_at < len(self.lines):
                self._looked_at += 1
                if condition(self.lines[self._looked_at - 1]):
                    return self.lines[self._looked_at - 1]
            time.sleep(0.005)
        raise AssertionError(f"the chair did not do so: {self.lines[-3:]}")
