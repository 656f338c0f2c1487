"""A folder of backups belongs to one clinic: another one is refused, and the restored one goes on in it."""

from pathlib import Path

import pytest
from store.keeping.filled_clinic import two_patients

from app.features.backup.backup_file import read_backup
from app.features.backup.backup_folder import BackupFolder
from app.features.backup.contents import clinic_mark
from app.features.backup.night_secret import opened_folder
from app.features.backup.restoration import restore
from app.features.backup.service import make_backup
from app.refusals import Refusal
from app.settings import Settings


@pytest.fixture
def clinics(tmp_path: Path) -> list[Settings]:
    both = [Settings(state=tmp_path / name) for name in ("clinic", "neighbour")]
    for one in both:
        two_patients(one, "Zebra")
    return both


def made(settings: Settings, stick: Path) -> Path:
    return stick / make_backup(settings, stick, None, with_keys=False, progress=lambda *_: None).name


def contents_of(folder: Path) -> dict[Path, bytes]:
    return {file: file.read_bytes() for file in folder.rglob("*") if file.is_file()}


def test_another_clinic_is_refused_and_changes_nothing(clinics: list[Settings], stick: Path) -> None:
    made(clinics[0], stick)
    before = contents_of(stick)
    with pytest.raises(Refusal, match="backups of another clinic: choose a folder of its own"):
        made(clinics[1], stick)
    assert contents_of(stick) == before


def test_another_clinic_cannot_choose_it_for_its_nights(clinics: list[Settings], stick: Path) -> None:
    marks = [clinic_mark(one) for one in clinics]
    assert opened_folder(stick, "", None, marks[0]) == (None, None)
    assert "backups of another clinic" in str(opened_folder(stick, "", None, marks[1])[1])


def test_the_restored_clinic_goes_on_in_its_folder(clinics: list[Settings], stick: Path, tmp_path: Path) -> None:
    restored = Settings(state=tmp_path / "restored")
    restore(made(clinics[0], stick), restored, None, frozenset())
    read_backup(made(restored, stick), None)
    assert len(BackupFolder(stick, None).names()) == 1  # of one day the newest


def test_a_damaged_header_is_one_sentence(clinics: list[Settings], stick: Path) -> None:
    for header in ("[]", '{"identity": null, "clinic": 1}', '{"identity": 1, "clinic": ""}', "{}"):
        (stick / "bodydrive-backups.json").write_text(header)
        with pytest.raises(Refusal, match="is no folder of backups"):
            made(clinics[0], stick)
