"""Measures the control loop beside a backup of 10 GB of recordings against the loop alone, in turn."""

import json
import os
import shutil
import signal
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

import numpy as np

from app.clock import monotonic
from app.file_modes import OWNER_FOLDER
from app.settings import Settings
from app.store.database import Database
from bench.children import ROOT, module
from bench.loop import measured
from bench.row import Row

PAIRS: Final = 6
SECONDS: Final = 10.0
GIGABYTES: Final = 10
RUN: Final = 100_000_000  # bytes of one recording
ROOM: Final = 3  # times the recordings, which must be free on the disk
PERCENTILES: Final = {"median": (50.0, None), "p99": (99.0, None), "p99.9": (99.9, 1.2)}  # percentile, target


def measure_beside_backup(pairs: int = PAIRS, seconds: float = SECONDS, gigabytes: int = GIGABYTES) -> list[Row]:
    """Return the loop's times beside a backup over those without, all runs of each kind together."""
    with tempfile.TemporaryDirectory(prefix="bench-backup-") as folder:
        free = shutil.disk_usage(folder).free // 1_000_000_000 // ROOM
        size = min(gigabytes, int(free))
        settings = _clinic(Path(folder) / "clinic", size)
        alone, beside = [], []
        with _backups(settings, Path(folder)) as backups:
            for _ in range(pairs):
                alone += measured(seconds)["loop"]
                backups.go_on()
                beside += measured(seconds)["loop"]
                backups.pause()
        words = f"{backups.made} backups done, {backups.first:.0f} s for the first" if backups.made else "none done yet"
    rows = []
    for name, (percentile, reach) in PERCENTILES.items():
        two = [1e6 * float(np.percentile(times, percentile)) for times in (beside, alone)]
        details = (
            f"{two[0]:.0f} us against {two[1]:.0f} us, {pairs} runs of {seconds:g} s each, in turn; {size} GB of "
            f"recordings, {words}"
        )
        rows.append(
            Row(f"UDP in to UDP out at 1 kHz beside a backup: {name}", [two[0] / two[1]], "x", reach, "lower", details)
        )
    return rows


def _clinic(state: Path, gigabytes: int) -> Settings:
    """Make a clinic with recordings of bytes that no file system stores in less room."""
    settings = Settings(state=state)
    Database(settings.database).close()
    noise = os.urandom(1_000_000)
    for number in range(gigabytes * 1_000_000_000 // RUN):
        folder = settings.runs / f"{number:032x}"
        folder.mkdir(mode=OWNER_FOLDER, parents=True)
        (folder / "end.json").write_text("{}")
        with (folder / "run.parquet").open("wb") as file:
            for part in range(RUN // len(noise)):
                file.write(b"%016d%016d" % (number, part) + noise[32:])
            file.flush()
            os.fsync(file.fileno())
            os.posix_fadvise(file.fileno(), 0, 0, os.POSIX_FADV_DONTNEED)  # as after a night: not in memory
    return settings


class _Backups:
    """One backup after the other, in the process that the web process starts for it; paused between the runs."""

    def __init__(self, settings: Settings, folder: Path) -> None:
        self._settings, self._folder = settings, folder
        self._process: subprocess.Popen[str] | None = None
        self._used = self._since = 0.0
        self.made, self.first = 0, 0.0

    def go_on(self) -> None:
        """Go on with the backup, or begin the next one."""
        if self._process is not None and self._process.poll() is not None:
            self.end()
        if self._process is None:
            target = self._folder / f"stick-{self.made}"
            target.mkdir()
            job = {"state": str(self._settings.state), "target": str(target), "with_keys": False}
            job |= {"secret": None}
            command = module("app.features.backup.backup_process")
            pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.DEVNULL}
            self._process = subprocess.Popen(command, text=True, cwd=ROOT, **pipes)  # type: ignore[call-overload]
            assert self._process is not None
            assert self._process.stdin is not None
            self._process.stdin.write(json.dumps(job) + "\n")
            self._process.stdin.close()
        else:
            self._process.send_signal(signal.SIGCONT)
        self._since = monotonic()

    def pause(self) -> None:
        """Stop the process until `go_on`."""
        assert self._process is not None
        self._used += monotonic() - self._since
        if self._process.poll() is None:
            self._process.send_signal(signal.SIGSTOP)

    def end(self) -> None:
        """End what runs; count it when it was done."""
        if self._process is None:
            return
        if self._process.poll() == 0:
            shutil.rmtree(self._folder / f"stick-{self.made}")
            self.first = self.first or self._used
            self.made += 1
        self._process.kill()
        self._process.wait()
        self._process, self._used = None, 0.0


@contextmanager
def _backups(settings: Settings, folder: Path) -> Iterator[_Backups]:
    backups = _Backups(settings, folder)
    try:
        yield backups
    finally:
        backups.end()
