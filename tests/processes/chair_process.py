"""A real receiver process for tests, with its lines, its stop switch and its kill."""

import json
import signal
import subprocess
import sys
import threading
import time

from app.clock import monotonic
from app.hardware.chair.key import new_key, write_key
from app.speed_limits import HIGHEST_SPEEDS

PATIENCE = 60.0  # s


def wait_until(condition):
    """Wait until a condition holds."""
    until = monotonic() + PATIENCE
    while not condition():
        assert monotonic() < until, "it did not come to that in time"
        time.sleep(0.005)


class Receiving:
    """A receiver's process, and the lines that it prints, as they come; `words` is what it says on stderr."""

    def __init__(self, key_file, *options, output="stdout", interpreter=(), lines=None, **more):
        command = [sys.executable, *interpreter, "-m", "app.hardware.chair.receive", "--output", output]
        self.process = subprocess.Popen(
            [*command, "--key-file", str(key_file), *options],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            **more,
        )
        self.lines = [] if lines is None else lines
        self.words = self.process.stderr.readline()
        assert self.words.startswith("listening on 127.0.0.1:"), self.words
        self.port = int(self.words.rpartition(":")[2])
        self._threads = [threading.Thread(target=self._read), threading.Thread(target=self._read_errors)]
        for thread in self._threads:
            thread.start()

    def _read(self):
        for line in self.process.stdout:
            self._pause()
            self.lines.append(json.loads(line) if line.startswith("{") else line)

    def _pause(self):
        """Wait before a line is kept."""

    def _read_errors(self):
        for line in self.process.stderr:
            self.words += line

    def end(self, number):
        """Send a signal, wait for the end, and return the exit code."""
        self.process.send_signal(number)
        code = self.process.wait(PATIENCE)
        for thread in self._threads:
            thread.join(PATIENCE)
        return code

    def close(self, number=signal.SIGKILL):
        """End it, unless it has ended by itself."""
        self.end(number)
        self.process.stdout.close()
        self.process.stderr.close()


class ReceiverProcess:
    """A receiver with a key and a stop switch; its lines are kept as they come, also after it is started again."""

    def __init__(self, folder, port=0, *options, output="stdout"):
        self.folder, self._options, self._port, self._output = folder, options, port, output
        self.key_file, self._switch = folder / "7.key", folder / "switch"
        if not self.key_file.exists():
            write_key(self.key_file, new_key(7))
        self.press(False)
        self.lines = []
        self.start()

    def start(self):
        """Start it, on the same port as before."""
        options = ("--stop-input", str(self._switch), "--port", str(self._port), *self._options)
        self._receiving = Receiving(self.key_file, *options, output=self._output, lines=self.lines)
        self._port = self._receiving.port

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
        return self._receiving.process.pid

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
        self._receiving.close()

    def close(self):
        self._receiving.close(signal.SIGTERM)
