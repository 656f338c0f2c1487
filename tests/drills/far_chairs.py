"""Real receivers whose outputs end in emulated chairs; what each fault of a chair does."""

import os
import pty
import select
import threading
import tty
from contextlib import suppress
from importlib.util import find_spec

from hardware.chair.far_ends import Board
from hardware.chair.ros_network import BETWEEN_PROCESSES
from processes.chair_process import ReceiverProcess

from app.clock import MonotonicClock, monotonic
from app.hardware.chair.chair_document import ASSUMED_SPEED, ASSUMED_TURN_RATE
from app.hardware.chair.key import new_key, read_key, write_key
from app.hardware.chair.whill_emulator import EmulatedWhillLine

NETWORK = {"CYCLONEDDS_URI": BETWEEN_PROCESSES, "ROS_DOMAIN_ID": "87"}  # of the environment of all outputs
LOOK_EVERY = 0.002  # s
LINE_EVERY = 0.1  # s: longest time between two lines
PAUSE = 0.005  # s
COMMAND_BYTES, COMMAND_MAGIC = 38, b"BMIC"
PER_MILLE = 1000
TREAD = 0.5  # m


class WhillEnd:
    """A WHILL at the end of a pseudo-terminal."""

    faults = ("hand", "error", "off")

    def __init__(self, _secret):
        self._line = EmulatedWhillLine()
        self.options = ("--device", self._line.device, "--tread", str(TREAD), "--backward-motor", "right")

    @property
    def speeds(self):
        return self._line.v, self._line.omega

    def set(self, fault, is_there):
        if fault == "hand":
            self._line.joystick = (0, -40 if is_there else 0)
        elif fault == "error":
            self._line.error = 12 if is_there else 0
        else:
            self._line.power = 0 if is_there else 1

    def close(self):
        self._line.close()


class BoardEnd(Board):
    """The board of the analog output at the end of a pseudo-terminal, and a chair without a chair document."""

    faults = ("restart", "converter", "hang", "cable", "kill")

    def __init__(self, secret):
        super().__init__(secret)
        self._unplugged = False
        self._line, self._far = pty.openpty()
        tty.setraw(self._far)  # otherwise what the board says comes back to it
        os.set_blocking(self._line, False)
        self.options = ("--device", os.ttyname(self._far))
        self._ending = threading.Event()
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    @property
    def speeds(self):
        ahead, right = self.deflection
        return ASSUMED_SPEED * ahead / PER_MILLE, -ASSUMED_TURN_RATE * right / PER_MILLE

    def set(self, fault, is_there):
        if fault == "cable":
            self._unplugged = is_there
        elif fault == "hang":
            self.dead = is_there
        elif fault == "converter":
            self.state = 4 if is_there else 0
            self.centre()
        elif is_there:
            self.reboot()

    def close(self):
        self._ending.set()
        self._thread.join()
        os.close(self._line)
        os.close(self._far)

    def _run(self):
        received = b""
        while not self._ending.is_set():
            with suppress(OSError):
                if select.select([self._line], [], [], PAUSE)[0]:
                    received += os.read(self._line, 4096)
            t = monotonic()
            if self._unplugged:
                received = b""
            received = received[max(0, received.find(COMMAND_MAGIC)) :]  # a receiver may be killed within a command
            while len(received) >= COMMAND_BYTES:
                self.take(received[:COMMAND_BYTES], t)
                received = received[COMMAND_BYTES:]
            if not self._unplugged:
                with suppress(OSError):
                    os.write(self._line, self.sent(t))
            self.watch(t)


FAR_ENDS = {"whill": WhillEnd, "analog": BoardEnd}
if find_spec("cyclonedds"):  # not every machine has this library: it is the extra ros2
    from drills.dds_ends import LuciEnd, RosEnd

    FAR_ENDS |= {"luci": LuciEnd, "ros2": RosEnd}


class FarChair(ReceiverProcess):
    """A receiver with one of the outputs; its lines say what the far end does, "armed" while that moves.

    The environment must have `NETWORK`.
    """

    def __init__(self, folder, output):
        key_file = folder / "7.key"
        write_key(key_file, new_key(7))
        self.far = FAR_ENDS[output](read_key(key_file).secret)
        super().__init__(folder, 0, *self.far.options, output=output)
        self._is_over = threading.Event()
        self._looking = threading.Thread(target=self._look)
        self._looking.start()

    def close(self):
        self._is_over.set()
        self._looking.join()
        super().close()
        self.far.close()

    def _look(self):
        clock, last, due = MonotonicClock(), None, 0.0
        while not self._is_over.is_set():
            v, omega = self.far.speeds
            t = clock.now()
            if (v, omega) != last or t >= due:
                state = "armed" if v or omega else "disarmed"
                self.lines.append({"t": t, "state": state, "v": v, "omega": omega})
                last, due = (v, omega), t + LINE_EVERY
            clock.sleep_until(t + LOOK_EVERY)
