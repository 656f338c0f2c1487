"""After a program was killed, the number of rows of a run is that of the rows on the disk, and none is forgotten."""

import random
import shutil
import signal
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import pytest
from clinic_rows import rows_in
from recording.test_recording_killed import KILLED

from app.features.exports.recorded_runs import recorded_runs
from app.recording.reader import CUT, kept_rows, read_run
from app.session.runs import NAMELESS, SessionRuns
from app.store.database import Database
from app.store.runs import add_run
from app.store.tables import LogEntry, Run
from folders import ROOT


def killed_recording(folder: Path, after: float) -> int:
    """Record in a process of its own, kill it, and return how many rows it has said last."""
    words = [sys.executable, "-c", KILLED, str(folder), str(ROOT / "tests")]
    process = subprocess.Popen(words, stdout=subprocess.PIPE)
    assert process.stdout is not None
    try:
        said = [process.stdout.readline() for _ in range(2)]
        threading.Event().wait(after)
    finally:
        process.send_signal(signal.SIGKILL)
        said += process.communicate()[0].splitlines(keepends=True)
    return int([line for line in said if line.endswith(b"\n")][-1])


@pytest.fixture(scope="module")
def killed_at_once(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a recording whose process was killed."""
    folder = tmp_path_factory.mktemp("killed") / "unknown"
    killed_recording(folder, 0.0)
    return folder


@pytest.fixture
def interrupted(database: Database, killed_at_once: Path, tmp_path: Path) -> tuple[Database, SessionRuns, Path]:
    """A clinic that was killed while it recorded `known`; of `unknown` there is no row yet."""
    runs = tmp_path / "runs"
    with rows_in(database) as rows:
        session = rows.session()
        for run in ("known", "gone"):
            add_run(rows.db, run, session.id, "drive", run)
    shutil.copytree(killed_at_once, runs / "unknown")
    return database, SessionRuns(database, None, runs, lambda: True), runs  # type: ignore[arg-type]


@pytest.mark.parametrize("seed", range(3))
def test_the_row_of_a_killed_run_says_what_is_on_the_disk(interrupted: Any, seed: int) -> None:
    database, runs, folder = interrupted
    said = killed_recording(folder / "known", random.Random(seed).uniform(0.0, 0.6))
    runs.close_interrupted()
    read = read_run(folder / "known")
    with database.transaction() as db:
        known, gone = db.get_one(Run, "known"), db.get_one(Run, "gone")
        assert (known.rows, known.dropped) == (read.rows, None)
        assert read.rows >= said
        assert (gone.rows, gone.ended is None) == (None, False)
        assert [run.folder.name for run in recorded_runs(db, 1, None, folder)] == ["known", "gone"]
    end = read.columns["t"][-1] - read.columns["t"][0]
    says = f"It ends {end:.2f} s after its first row; of the time until the cut, at most 0.5 s are lost."
    assert str(read.loss) == f"{CUT} {says}"


def test_a_recording_without_a_row_is_kept_and_named_once(interrupted: Any) -> None:
    database, runs, folder = interrupted
    assert [runs.close_interrupted() for _ in range(2)] == [["unknown"], ["unknown"]]
    with database.transaction() as db:
        (logged,) = db.query(LogEntry).where(LogEntry.what == NAMELESS)
    assert logged.details == {"recordings": ["unknown"]}
    assert kept_rows(folder / "unknown")
