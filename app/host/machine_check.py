"""Measurements of what this machine grants the control loop and the clinic, each with a sentence."""

import errno
import shutil
import socket
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from math import ceil
from pathlib import Path
from typing import Literal

from app.clock import Clock
from app.disk_room import LITTLE_ROOM, ROOM_TO_RECORD
from app.settings import PACKAGE
from app.texts import Text

PERIOD = 0.01  # s: the loop's, when the shirt sends at 100 Hz
FEW = 0.001  # share of late ticks that a drive does not feel
PORTS = (8080, 8443)  # of the clinic, when nobody chooses others
FLUENT, TOO_FEW = 20.0, 10.0  # pictures a second; with fewer than the latter the 3D view is drawn coarser

Verdict = Literal["good", "attention", "bad"]


@dataclass(frozen=True, slots=True)
class Finding:
    """What one measurement found."""

    verdict: Verdict
    message: str


def measure_lateness(clock: Clock, seconds: float) -> list[float]:
    """Wait for absolute deadlines as the control loop does; return by how much each was missed, s."""
    start = clock.now()
    lateness = []
    for tick in range(1, round(seconds / PERIOD) + 1):
        deadline = start + tick * PERIOD
        clock.sleep_until(deadline)
        lateness.append(max(0.0, clock.now() - deadline))
    return lateness


def lateness_finding(lateness: Sequence[float]) -> Finding:
    """Return whether the loop comes in time; a tick that is late by more than a period is one too many."""
    ranked = sorted(lateness)
    late = sum(each > PERIOD for each in ranked)
    p99 = ranked[ceil(0.99 * len(ranked)) - 1]
    message = (
        f"Of {len(ranked)} ticks of the control loop, {late} came more than {1000 * PERIOD:.0f} ms late; "
        f"99 of 100 came within {1000 * p99:.1f} ms, the latest after {1000 * ranked[-1]:.1f} ms."
    )
    if late == 0:
        return Finding("good", message)
    if late <= FEW * len(ranked):
        return Finding("attention", f"{message} Close other programs while driving.")
    return Finding("bad", f"{message} This machine is too busy or too slow to drive a chair.")


def real_time_findings(texts: Sequence[Text]) -> list[Finding]:
    """Return the findings of what `app.realtime.go_real_time` was granted, one for each of its texts."""
    return [Finding("attention" if text.id.endswith("-refused") else "good", str(text)) for text in texts]


def disk_finding(free: int) -> Finding:
    """Return whether there is room for recordings; `free` in bytes."""
    message = f"{free / 1e9:.1f} GB of the disk are free."
    if free < ROOM_TO_RECORD:
        return Finding("bad", f"{message} Nothing can be recorded: make room.")
    return Finding("attention", f"{message} Make room soon.") if free < LITTLE_ROOM else Finding("good", message)


def free_room(folder: Path) -> int:
    """Return the free bytes on the disk of a folder, which need not exist yet."""
    existing = next(place for place in (folder, *folder.parents) if place.exists())
    return shutil.disk_usage(existing).free


def clock_finding(now: datetime, installed: datetime, *, is_kept: bool | None) -> Finding:
    """Return whether the clock can be right; certificates and the log depend on it.

    `installed` is when the program was; `is_kept`: whether a time server keeps the clock, None when unknown.
    """
    message = f"The clock shows {now:%Y-%m-%d %H:%M} UTC"
    if now < installed:
        return Finding("bad", f"{message}, but the program was installed later: set the clock.")
    if is_kept is None:
        return Finding("good", f"{message}.")
    if is_kept:
        return Finding("good", f"{message}, and a time server keeps it right.")
    return Finding("attention", f"{message}, and no time server keeps it right: compare it with a clock now and then.")


def clock_is_kept() -> bool | None:
    """Return whether a time server keeps this machine's clock, None when the system gives no answer."""
    try:
        status = subprocess.run(
            ["timedatectl", "show", "--property=NTPSynchronized", "--value"],
            capture_output=True,
            text=True,
            check=False,
            timeout=5.0,
        )
    except (OSError, subprocess.TimeoutExpired):
        return None
    return {"yes": True, "no": False}.get(status.stdout.strip())


def port_finding(port: int, *, is_own: bool) -> Finding:
    """Return whether a clinic on this machine can listen on a port; `is_own`: the clinic that asks does so now."""
    if is_own:
        return Finding("good", f"Port {port} is the one of this clinic.")
    try:
        socket.create_server(("127.0.0.1", port)).close()
    except OSError as error:
        if error.errno == errno.EACCES:
            return Finding("attention", f"Port {port} is for the system: this account may not use it.")
        return Finding("attention", f"Port {port} is in use, perhaps by the clinic itself.")
    return Finding("good", f"Port {port} is free.")


def program_finding(*, is_compiled: bool) -> Finding:
    """Return whether the control loop's calculations run compiled."""
    if is_compiled:
        return Finding("good", "The control loop's calculations run compiled.")
    return Finding("attention", "The control loop's calculations run as plain Python: the same results, but slower.")


def screen_finding(name: str, rate: float | None) -> Finding:
    """Return whether a screen draws fast enough for the 3D view.

    `name` says whose screen it is; `rate` in pictures a second, None when the screen did not answer.
    """
    if rate is None:
        return Finding("attention", f"{name} did not answer: it is out of view, locked or asleep.")
    message = f"{name} draws {rate:.0f} pictures a second."
    if rate >= FLUENT:
        return Finding("good", message)
    advice = "Close other programs there, or choose the drawn plan."
    return Finding("attention" if rate >= TOO_FEW else "bad", f"{message} {advice}")


def install_time() -> float:
    """Return when this file was installed, s since 1970."""
    return (PACKAGE / "settings.py").stat().st_ctime


def summary(findings: Sequence[Finding]) -> Finding:
    """Return whether the machine is good enough, by its worst finding."""
    verdicts = {finding.verdict for finding in findings}
    if "bad" in verdicts:
        return Finding("bad", "This computer is not good enough for driving as it is.")
    if "attention" in verdicts:
        return Finding("attention", "This computer is good enough for driving, and something could be better.")
    return Finding("good", "This computer is good enough for driving.")
