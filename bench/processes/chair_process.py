"""The stand-in chair as a process, with the scheduling that a receiver has: notes when each command came.

Arguments: a bound socket's descriptor, a key file. Prints the port of its sender as soon as that drives; when a line
comes on stdin, the times (monotonic s) of all commands, and of those that drive.
"""

import json
import socket
import sys
import threading
from pathlib import Path

from app.hardware.chair.key import read_key
from app.hardware.chair.packet import DRIVE, Command
from app.realtime import go_real_time
from bench.processes.listening import Address, listen
from bench.processes.stand_in_chair import StandInChair


def main(descriptor: int, key_file: Path) -> None:
    """Be the chair until told to tell."""
    times: list[float] = []
    driving: list[float] = []
    ending = threading.Event()

    def note(command: Command, now: float, sender: Address) -> None:
        times.append(now)
        if command.flags & DRIVE:
            driving.append(now)
            if len(driving) == 1:
                _say(str(sender[1]))

    def wait() -> None:
        sys.stdin.readline()
        ending.set()

    threading.Thread(target=wait, daemon=True).start()
    go_real_time()
    with socket.socket(fileno=descriptor) as opened:
        listen(StandInChair(read_key(key_file)), opened, note, lambda: not ending.is_set())
    _say(json.dumps({"times": times, "driving": driving}))


def _say(line: str) -> None:
    sys.stdout.write(f"{line}\n")
    sys.stdout.flush()


if __name__ == "__main__":
    main(int(sys.argv[1]), Path(sys.argv[2]))
