"""Chairs and their keys in the database and on the disk."""

import stat
from pathlib import Path

import pytest
from sqlalchemy.orm import Session

from app.hardware.chair.key import read_key
from app.refusals import Conflict, NotFound
from app.session.equipment.pairing import key_file, pair_chair, unpair_chair
from app.speed_limits import HIGHEST_SPEEDS, Speeds
from app.store import chairs
from app.store.chairs import chairs_of, find_chair, limits_of
from app.store.people import add_clinic
from app.store.tables import Clinic


@pytest.fixture
def clinic(db: Session) -> Clinic:
    return add_clinic(db, "Clinic")


def paired(db: Session, clinic: Clinic, keys: Path, name: str) -> int:
    return pair_chair(db, clinic, keys, name, "10.0.0.7", 5354, Speeds())[0].id


def test_each_chair_has_a_key_of_its_own(db: Session, clinic: Clinic, tmp_path: Path) -> None:
    keys = tmp_path / "keys"
    ids = [paired(db, clinic, keys, name) for name in ("Blue", "Red")]
    assert [chair.key_id for chair in chairs_of(db)] == [1, 2]
    assert len({read_key(key_file(keys, key_id)).secret for key_id in (1, 2)}) == 2
    assert all(stat.S_IMODE(file.stat().st_mode) == 0o600 for file in keys.iterdir())
    unpair_chair(db, keys, ids[0])
    assert [chair.name for chair in chairs_of(db)] == ["Red"]
    assert [file.name for file in keys.iterdir()] == ["2.key"]
    with pytest.raises(NotFound):
        find_chair(db, ids[0])
    assert paired(db, clinic, keys, "Blue") == ids[1] + 1
    assert chairs_of(db)[-1].key_id == 3


def test_a_key_that_an_interrupted_pairing_left_is_not_overwritten(db: Session, clinic: Clinic, tmp_path: Path) -> None:
    (tmp_path / "1.key").write_text("left")
    paired(db, clinic, tmp_path, "Blue")
    assert chairs_of(db)[0].key_id == 2
    assert (tmp_path / "1.key").read_text() == "left"


def test_two_chairs_of_one_name_would_be_mixed_up(db: Session, clinic: Clinic, tmp_path: Path) -> None:
    paired(db, clinic, tmp_path, "Blue")
    with pytest.raises(Conflict, match="already a chair called 'Blue'"):
        paired(db, clinic, tmp_path, "Blue")
    assert [file.name for file in tmp_path.glob("*.key")] == ["1.key"]


def test_when_every_number_was_used_there_is_a_sentence(
    db: Session, clinic: Clinic, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(chairs, "LARGEST_KEY_ID", 1)
    paired(db, clinic, tmp_path, "Blue")
    with pytest.raises(Conflict, match="Every number"):
        paired(db, clinic, tmp_path, "Red")


def test_a_limit_that_an_older_program_did_not_know_is_that_of_the_application(clinic: Clinic) -> None:
    clinic.limits = {"forward": 0.4}
    assert limits_of(clinic) == HIGHEST_SPEEDS.model_copy(update={"forward": 0.4})
    assert limits_of(None) == HIGHEST_SPEEDS
