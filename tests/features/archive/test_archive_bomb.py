"""An archive that would need far more memory than its size is refused by the process that imports it."""

import subprocess
import sys
from pathlib import Path

from features.archive.archive_clinics import archived_clinic, empty_clinic, rewrite, state_of

IMPORT = """
import sys
from pathlib import Path
from app import child_process
from app.features.archive.archive_import import import_apart
child_process.MOST_MEMORY = 1_000_000_000
state, package = map(Path, sys.argv[1:])
import_apart(state / "bodydrive.sqlite", 1, package, "Ben", state / "runs", state / "unpacked", None)
"""
LISTS = 20_000_000  # about 1.3 GB in memory, 100 kB in the file


def test_an_archive_that_needs_too_much_memory_is_one_sentence_and_changes_nothing(tmp_path: Path) -> None:
    package, other = archived_clinic(tmp_path / "first"), empty_clinic(tmp_path / "other")
    rewrite(package, tmp_path / "bomb.zip", text=("12.5", f"[{'[],' * LISTS}1]"))
    before = state_of(other)
    assert "because it needs too much memory; nothing was imported." in problem_of(other.state, tmp_path / "bomb.zip")
    assert state_of(other) == before
    assert problem_of(other.state, package) == ""  # the limit leaves enough for a real archive


def problem_of(state: Path, package: Path) -> str:
    """Import an archive in a process with little memory; return the end of what it complains of."""
    command: list[str | Path] = [sys.executable, "-c", IMPORT, state, package]
    ended = subprocess.run(command, check=False, capture_output=True, text=True, timeout=100)
    return ended.stderr.strip().rpartition("\n")[2]
