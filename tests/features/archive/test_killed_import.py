"""An import whose process is killed: its unpacked recordings go with the next import, start or erasure."""

import signal
import subprocess
import sys
from contextlib import closing
from pathlib import Path

import pytest
from store.keeping.filled_clinic import two_patients

from app.features.archive.archive_import import import_archive
from app.settings import Settings
from app.store.database import Database
from app.store.files.temporary_folders import remove_temporary_folders, temporary_folder
from app.store.keeping.erasure import erase_due

KILLED = """
import os, signal, sys
from pathlib import Path
from app.features.archive import archive_import
from app.store.database import Database
archive_import._add = lambda *_: os.kill(os.getpid(), signal.SIGKILL)
state, package = map(Path, sys.argv[1:])
archive_import.import_archive(Database(state / "bodydrive.sqlite"), package, "Ben", state / "runs")
"""


@pytest.fixture
def settings(tmp_path: Path, package: Path) -> Settings:
    """Return a clinic in which an import was killed when it had unpacked the recordings."""
    made = Settings(state=tmp_path / "clinic")
    two_patients(made, "Zebra")
    ended = subprocess.run([sys.executable, "-c", KILLED, made.state, package], check=False, timeout=60)
    assert ended.returncode == -signal.SIGKILL
    assert unpacked(made)
    return made


def unpacked(settings: Settings) -> list[Path]:
    return [file for folder in settings.state.glob(".import-*") for file in folder.rglob("*")]


def test_the_next_start_or_erasure_removes_it(settings: Settings) -> None:
    with closing(Database(settings.database)) as database:
        erase_due(database, settings)  # what a start does first
    assert unpacked(settings) == []


def test_the_next_import_removes_it(settings: Settings, package: Path) -> None:
    with closing(Database(settings.database)) as database:
        assert import_archive(database, package, "Ben", settings.runs).is_new
    assert list(settings.state.glob(".import-*")) == []


def test_what_a_killed_export_left_goes_likewise(tmp_path: Path) -> None:
    (tmp_path / ".export-left" / "part").mkdir(parents=True)
    remove_temporary_folders(tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_an_import_that_goes_on_keeps_its_recordings(tmp_path: Path) -> None:
    with temporary_folder(tmp_path, "import") as first, temporary_folder(tmp_path, "export") as second:
        (first / "run").mkdir()
        remove_temporary_folders(tmp_path)
        assert (first / "run").is_dir()
        assert second.is_dir()
    assert list(tmp_path.iterdir()) == []
