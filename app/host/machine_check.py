"""Measurements of what this machine grants the control loop and the clinic, each with a sentence."""

import errno
import shutil
import socket
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from math import ceil
from pathlib import Path
from typing import Literal

from app.clock import Clock, MonotonicClock, utc_now
from app.disk_room import LITTLE_ROOM, ROOM_TO_RECORD
from app.ports import HTTP_PORT, HTTPS_PORT
from app.realtime import go_real_time
from app.settings import PACKAGE
from app.texts import Figure, Text

PERIOD = 0.01  # s: the loop's, when the shirt sends at 100 Hz
FEW = 0.001  # share of late ticks that a drive does not feel
PORTS = (HTTP_PORT, HTTPS_PORT)
FLUENT, TOO_FEW = 20.0, 10.0  # pictures a second; with fewer than the latter the 3D view is drawn coarser

Verdict = Literal["good", "attention", "bad"]


@dataclass(frozen=True, slots=True)
class Finding:
    """What one measurement found."""

    verdict: Verdict
    message: Text


def machine_findings(seconds: float, folder: Path, own_ports: Sequence[int], *, is_compiled: bool) -> list[Finding]:
    """Measure what this machine grants, for `seconds`, and return all that was found.

    `own_ports` are those of the clinic that asks; `is_compiled`: whether the control loop's calculations are.
    """
    real_time = real_time_findings([Text(message) for message in go_real_time()])
    installed = datetime.fromtimestamp(install_time(), UTC)
    return [
        lateness_finding(measure_lateness(MonotonicClock(), seconds)),
        *real_time,
        disk_finding(free_room(folder)),
        clock_finding(utc_now(), installed, is_kept=clock_is_kept()),
        *(port_finding(port, is_own=bool(own_ports)) for port in own_ports or PORTS),
        program_finding(is_compiled=is_compiled),
    ]


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
    verdict: Verdict = "good" if late == 0 else "attention" if late <= FEW * len(ranked) else "bad"
    message = Text(
        f"host-lateness-{verdict}",
        ticks=len(ranked),
        late=late,
        limit=Figure(1000 * PERIOD),
        most=Figure(1000 * p99, 1),
        latest=Figure(1000 * ranked[-1], 1),
    )
    return Finding(verdict, message)


def real_time_findings(texts: Sequence[Text]) -> list[Finding]:
    """Return the findings of what `app.realtime.go_real_time` was granted, one for each of its texts."""
    return [Finding("attention" if text.id.endswith("-refused") else "good", text) for text in texts]


def disk_finding(free: int) -> Finding:
    """Return whether there is room for recordings; `free` in bytes."""
    verdict: Verdict = "bad" if free < ROOM_TO_RECORD else "attention" if free < LITTLE_ROOM else "good"
    return Finding(verdict, Text(f"host-disk-{verdict}", free=Figure(free / 1e9, 1)))


def free_room(folder: Path) -> int:
    """Return the free bytes on the disk of a folder, which need not exist yet."""
    existing = next(place for place in (folder, *folder.parents) if place.exists())
    return shutil.disk_usage(existing).free


def clock_finding(now: datetime, installed: datetime, *, is_kept: bool | None) -> Finding:
    """Return whether the clock can be right; certificates and the log depend on it.

    `installed` is when the program was; `is_kept`: whether a time server keeps the clock, None when unknown.
    """
    time = now.astimezone(UTC).replace(tzinfo=None)
    if now < installed:
        return Finding("bad", Text("host-clock-early", time=time))
    if is_kept is None:
        return Finding("good", Text("host-clock", time=time))
    if is_kept:
        return Finding("good", Text("host-clock-kept", time=time))
    return Finding("attention", Text("host-clock-not-kept", time=time))


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
        return Finding("good", Text("host-port-own", port=port))
    try:
        socket.create_server(("127.0.0.1", port)).close()
    except OSError as error:
        if error.errno == errno.EACCES:
            return Finding("attention", Text("host-port-of-system", port=port))
        return Finding("attention", Text("host-port-in-use", port=port))
    return Finding("good", Text("host-port-free", port=port))


def program_finding(*, is_compiled: bool) -> Finding:
    """Return whether the control loop's calculations run compiled."""
    if is_compiled:
        return Finding("good", Text("host-compiled"))
    return Finding("attention", Text("host-not-compiled"))


def screen_finding(name: str, rate: float | None) -> Finding:
    """Return whether a screen draws fast enough for the 3D view.

    `name` says whose screen it is; `rate` in pictures a second, None when the screen did not answer.
    """
    if rate is None:
        return Finding("attention", Text("host-screen-silent", name=name))
    if rate >= FLUENT:
        return Finding("good", Text("host-screen-good", name=name, rate=Figure(rate)))
    message = Text("host-screen-slow", name=name, rate=Figure(rate))
    return Finding("attention" if rate >= TOO_FEW else "bad", message)


def install_time() -> float:
    """Return when this file was installed, s since 1970."""
    return (PACKAGE / "settings.py").stat().st_ctime


def summary(findings: Sequence[Finding]) -> Finding:
    """Return whether the machine is good enough, by its worst finding."""
    verdicts = {finding.verdict for finding in findings}
    worst: Verdict = "bad" if "bad" in verdicts else "attention" if "attention" in verdicts else "good"
    return Finding(worst, Text(f"host-summary-{worst}"))
