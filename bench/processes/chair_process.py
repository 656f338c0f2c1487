"""A chair's real receiver as a process, with a receiver's scheduling; it notes when each command came.

Arguments: the descriptor of a bound socket, a key file. Prints the port of its sender at the first command that drives;
at a line on stdin, prints the times (monotonic s) of all accepted commands, and of those that drive.
"""

import json
import socket
import sys
import threading
from pathlib import Path

from app.hardware.chair.key import read_key
from app.hardware.chair.packet import DRIVE, ChairCommand
from app.realtime import go_real_time
from bench.processes.measured_chair import Address, run_chair


def main(descriptor: int, key_file: Path) -> None:
    """Run the receiver until a line comes on stdin, then print the times."""
    times: list[float] = []
    driving: list[float] = []
    ending = threading.Event()

    def note(t: float, command: ChairCommand, sender: Address) -> None:
        times.append(t)
        if command.flags & DRIVE:
            driving.append(t)
            if len(driving) == 1:
                _print(str(sender[1]))

    def wait() -> None:
        sys.stdin.readline()
        ending.set()

    threading.Thread(target=wait, daemon=True).start()
    go_real_time()
    with socket.socket(fileno=descriptor) as opened:
        run_chair(read_key(key_file), opened, note, lambda: not ending.is_set())
    _print(json.dumps({"times": times, "driving": driving}))


def _print(line: str) -> None:
    sys.stdout.write(f"{line}\n")
    sys.stdout.flush()


if __name__ == "__main__":
    main(int(sys.argv[1]), Path(sys.argv[2]))
