"""A backup whose process is killed at any moment: the one before stays whole, and the next one is good."""

import json
import random
import subprocess
import sys
import time
from pathlib import Path

from store.keeping.filled_clinic import two_patients

from app.features.backup.backup_file import read_backup
from app.features.backup.backup_folder import BackupFolder
from app.settings import Settings

KILLS = 4


def begin(settings: Settings, stick: Path) -> subprocess.Popen[str]:
    job = {"state": str(settings.state), "target": str(stick), "with_keys": False, "secret": None}
    process = subprocess.Popen(
        [sys.executable, "-m", "app.features.backup.backup_process"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert process.stdin is not None
    process.stdin.write(json.dumps(job) + "\n")
    process.stdin.close()
    process.stdin = None
    return process


def test_a_killed_backup_harms_nothing(tmp_path: Path) -> None:
    settings, stick = Settings(state=tmp_path / "clinic"), tmp_path / "stick"
    two_patients(settings, "Zebra", "Heron")
    stick.mkdir()
    chance = random.Random(16)
    started = time.monotonic()
    out, _ = begin(settings, stick).communicate()
    duration = time.monotonic() - started
    first = json.loads(out.splitlines()[-1])["made"]["name"]
    for number in range(KILLS):
        folder = settings.runs / f"run-{number}"
        folder.mkdir()
        (folder / "end.json").write_bytes(chance.randbytes(3_000_000))
        process = begin(settings, stick)
        time.sleep(chance.uniform(0.2, 1.0) * duration)
        process.kill()
        process.communicate()
        if first in BackupFolder(stick, None).names():  # otherwise one of the same day has taken its place
            read_backup(stick / first, None)
    out, _ = begin(settings, stick).communicate()
    made = json.loads(out.splitlines()[-1])["made"]
    manifest = read_backup(stick / made["name"], None)
    assert len([file for file in manifest.files if file.path.endswith("/end.json")]) == KILLS + 2
    assert [file.name for file in stick.rglob(".*")] == []
    assert sorted(file.name for file in settings.backup.iterdir()) == ["lock"]
