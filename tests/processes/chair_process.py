"""A real receiver process for tests, with its lines, its stop switch and its kill."""

import json
import signal
import subprocess
import sys
import threading

from app.clock import monotonic
from app.hardware.chair.key import new_key, write_key
from app.speeds import HIGHEST_SPEEDS

PATIENCE = 60.0  # s


class ReceiverProcess:
    """`--output stdout`; its lines are kept as they come."""

    def __init__(self, folder, port=0, *options):
        self.folder, self._options = folder, options
        self.key_file, self._switch = folder / "7.key", folder / "switch"
        if not self.key_file.exists():
            write_key(self.key_file, new_key(7))
        self.press(False)
        self.lines = []
        self._process = self._errors = None
        self._port = port
        self.start()

    def start(self):
        """Start it, on the same port as before."""
        command = [sys.executable, "-m", "app.hardware.chair.receive", "--output", "stdout"]
        command += ["--key-file", str(self.key_file), "--stop-input", str(self._switch), "--port", str(self._port)]
        self._process = subprocess.Popen(
            [*command, *self._options], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        )
        said = self._process.stderr.readline()
        assert said.startswith("listening on "), said
        self._port = int(said.strip().rpartition(":")[2])
        self._threads = [
            threading.Thread(target=self._read, args=(self._process.stdout,)),
            threading.Thread(target=self._process.stderr.read),
        ]
        for thread in self._threads:
            thread.start()

    def _read(self, lines):
        for line in lines:
            self.lines.append(json.loads(line))

    def press(self, pressed):
        """Press or release the chair's stop switch."""
        new = self.folder / "switch.new"
        new.write_text("1" if pressed else "0")
        new.replace(self._switch)

    def config(self, **changes):
        where = {"name": "Salon", "host": "127.0.0.1", "port": self._port, "key_file": str(self.key_file)}
        return {"kind": "udp", **where, "speeds": HIGHEST_SPEEDS.model_dump(), **changes}

    @property
    def pid(self):
        return self._process.pid

    @property
    def newest(self):
        return self.lines[-1]

    def since(self, t):
        """Return the lines printed after `t` (monotonic s)."""
        return [line for line in self.lines if line["t"] > t]

    def standing_since(self, t):
        """Return the time (monotonic s), after `t`, since when all lines report standstill."""
        since = None
        for line in self.since(t):
            if line["v"] or line["omega"]:
                since = None
            elif since is None:
                since = line["t"]
        return since

    def wait_for(self, condition):
        until = monotonic() + PATIENCE
        pause = threading.Event()
        while monotonic() < until:
            found = next((line for line in reversed(self.lines[-20:]) if condition(line)), None)
            if found is not None:
                return found
            pause.wait(0.01)
        raise AssertionError(f"the chair did not get there within {PATIENCE:g} s: {self.lines[-3:]}")

    def kill(self):
        self._process.send_signal(signal.SIGKILL)
        self._join()

    def close(self):
        self._process.terminate()
        self._join()

    def _join(self):
        self._process.wait(PATIENCE)
        for thread in self._threads:
            thread.join(PATIENCE)
        self._process.stdout.close()
        self._process.stderr.close()
