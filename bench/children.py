"""Starts the processes of a benchmark and talks to them in lines."""

import socket
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Final

ROOT: Final = Path(__file__).resolve().parents[1]
BODYDRIVE: Final = (sys.executable, "-c", "from app.cli.main import main; main()")


def module(name: str) -> list[str]:
    """Return the command that runs a module of this program."""
    return [sys.executable, "-m", name]


def started(name: str, *arguments: str, descriptors: Sequence[int] = ()) -> subprocess.Popen[str]:
    """Start a module that reads and writes lines; it inherits the open `descriptors`."""
    return start_command([*module(name), *arguments], descriptors)


def start_command(command: Sequence[str], descriptors: Sequence[int] = ()) -> subprocess.Popen[str]:
    """Start a command that reads and writes lines; it inherits the open `descriptors`."""
    return subprocess.Popen(
        command,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        bufsize=1,
        cwd=ROOT,
        pass_fds=descriptors,
    )


def next_line(process: subprocess.Popen[str]) -> str:
    """Return the next line of a process; raise RuntimeError when the process has ended."""
    line = process.stdout.readline().strip() if process.stdout else ""
    if not line:
        raise RuntimeError("a part of the benchmark did not start, or ended early: its message stands above")
    return line


def ask(process: subprocess.Popen[str], word: str) -> str:
    """Write a word to a process and return its answer."""
    if process.stdin is not None:
        process.stdin.write(f"{word}\n")
        process.stdin.flush()
    return next_line(process)


def free_ports(count: int) -> list[int]:
    """Return ports that are free at this moment."""
    sockets = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(count)]
    try:
        for probe in sockets:
            probe.bind(("127.0.0.1", 0))
        return [int(probe.getsockname()[1]) for probe in sockets]
    finally:
        for probe in sockets:
            probe.close()
