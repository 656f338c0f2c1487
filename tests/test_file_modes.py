"""Only their owner can read a clinic's files, including those that an older program left open."""

import os
import stat
from pathlib import Path

import pytest

from app.cli.clinic_folder import keep_private
from app.file_modes import restrict
from app.settings import Settings

OPEN_FILES = (
    "bodydrive.sqlite",
    "bodydrive.sqlite-wal",
    "runs/a/run.json",
    "files/b.csv",
    "keys/1.key",
    "replaced/b.csv",
    "in-use",
)


@pytest.fixture(autouse=True)
def _mask():
    mask = os.umask(0o022)
    yield
    os.umask(mask)


@pytest.fixture
def state(tmp_path):
    """Yield a folder of an older installation."""
    for name in OPEN_FILES:
        file = tmp_path / "state" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("secret")
        file.chmod(0o664)
    return tmp_path / "state"


def readable_by_others(folder: Path) -> list[Path]:
    return [place for place in (folder, *folder.rglob("*")) if stat.S_IMODE(place.lstat().st_mode) & 0o077]


def test_an_older_installation_is_tightened_and_new_files_are_private(state):
    assert len(readable_by_others(state)) == len(OPEN_FILES) + 6
    assert keep_private(Settings(state=state)) == []
    (state / "runs" / "new").mkdir()
    (state / "runs" / "new" / "run.json").touch()
    assert readable_by_others(state) == []


def test_what_is_not_ours_keeps_its_rights_and_links_out_are_not_followed(state, tmp_path):
    elsewhere = tmp_path / "elsewhere.txt"
    elsewhere.touch()
    (state / "letters").mkdir()
    (state / "letters" / "a.txt").touch()
    (state / "runs" / "link").symlink_to(elsewhere)
    keep_private(Settings(state=state))
    assert readable_by_others(state / "letters")
    assert stat.S_IMODE(elsewhere.stat().st_mode) == 0o644
    assert stat.S_IMODE((state / "runs" / "a" / "run.json").stat().st_mode) == 0o600


def test_recordings_on_another_disk_behind_a_link_are_tightened(state, tmp_path):
    (state / "runs").rename(tmp_path / "large-disk")
    (state / "runs").symlink_to(tmp_path / "large-disk")
    keep_private(Settings(state=state))
    assert readable_by_others(tmp_path / "large-disk") == []


def test_what_cannot_be_tightened_is_said_in_a_sentence(state, monkeypatch):
    def refuse(self, mode):
        raise PermissionError(1, "Operation not permitted")

    monkeypatch.setattr(Path, "chmod", refuse)
    (sentence,) = keep_private(Settings(state=state))
    assert f"can read {len(OPEN_FILES) + 6} files" in str(sentence)
    assert restrict([state / "nowhere"]) == []


def test_the_state_of_nobody_yet_is_no_place(tmp_path):
    assert keep_private(Settings(state=tmp_path / "nowhere")) == []
    assert not (tmp_path / "nowhere").exists()


def test_a_folder_that_others_cannot_enter_is_not_searched(state, monkeypatch):
    keep_private(Settings(state=state))
    monkeypatch.setattr(Path, "iterdir", lambda folder: pytest.fail(f"{folder} was searched"))
    assert keep_private(Settings(state=state)) == []


def test_a_search_that_was_interrupted_is_done_again(state, monkeypatch):
    chmod = Path.chmod

    def interrupted(place, mode):
        if place.name == "run.json":
            raise KeyboardInterrupt
        chmod(place, mode)

    with monkeypatch.context() as patch:
        patch.setattr(Path, "chmod", interrupted)
        with pytest.raises(KeyboardInterrupt):
            keep_private(Settings(state=state))
    keep_private(Settings(state=state))
    assert readable_by_others(state) == []
