"""An archive flows to its reader while it is made: documents before any recording is read, and what was sent stays."""

import zipfile
from pathlib import Path

import pytest

from app.features.archive.archive_file import LIST, PATIENT, REPORT, open_archive
from app.features.archive.service import archive_steps

RUNS = ("run-a", "run-b")


@pytest.fixture
def folders(tmp_path: Path) -> list[Path]:
    made = [tmp_path / "runs" / name for name in RUNS]
    for folder in made:
        folder.mkdir(parents=True)
        for name in ("run.json", "run.parquet"):
            (folder / name).write_bytes(f"{folder.name} {name}".encode() * 40_000)
    return made


def beginning(package: Path, end: int) -> bytes:
    return package.read_bytes()[:end]


def test_the_documents_are_final_before_a_recording_is_read(tmp_path: Path) -> None:
    nowhere = [tmp_path / name for name in RUNS]  # to read one of them would find no file
    first, *_ = archive_steps("Riverside", {}, nowhere, lambda: b"<html>")
    final = first(tmp_path / "a.zip")
    begun = (tmp_path / "a.zip").read_bytes()[:final]
    assert PATIENT.encode() in begun
    assert REPORT.encode() in begun


def test_what_was_final_after_a_step_is_the_beginning_of_the_archive(tmp_path: Path, folders: list[Path]) -> None:
    package = tmp_path / "a.zip"
    begun = [beginning(package, step(package)) for step in archive_steps("Riverside", {}, folders, lambda: b"<p>")]
    whole = package.read_bytes()
    assert [whole.startswith(part) for part in begun] == [True] * 4
    assert [len(part) for part in begun] == sorted({len(part) for part in begun})


def test_the_list_is_written_last_and_named_first(tmp_path: Path, folders: list[Path]) -> None:
    package = tmp_path / "a.zip"
    for step in archive_steps("Riverside", {}, folders, None):
        step(package)
    with zipfile.ZipFile(package) as opened:
        entries = opened.infolist()
        assert opened.testzip() is None
    assert [info.filename for info in entries][:2] == [LIST, PATIENT]
    assert entries[0].header_offset == max(info.header_offset for info in entries)
    assert not any(info.comment for info in entries)
    with open_archive(package) as archive:
        archive.unpack_recordings(tmp_path / "unpacked", frozenset())
    for folder in folders:
        for file in folder.iterdir():
            assert (tmp_path / "unpacked" / folder.name / file.name).read_bytes() == file.read_bytes()
