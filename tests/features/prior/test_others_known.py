"""How many other people a clinic's prior says it knows in a shirt."""

from pathlib import Path
from typing import Any

import pytest
from clinic_rows import rows_in

from app.calibration.prior.documents import PersonEntry
from app.features.prior.entries import put_entry
from app.features.prior.service import ClinicPrior
from app.hardware.shirt.standard import standard_layout
from app.session.calibration.garment import Garment
from app.store.database import Database
from app.study.simulated_calibration import prior_of_wearers

LAYOUT = standard_layout()
GARMENT = Garment(LAYOUT, "simulated", 7)  # no prior ships for this simulated shirt


@pytest.fixture(scope="module")
def joints() -> Any:
    """Return what one simulated person taught of each joint."""
    (entry,) = prior_of_wearers(LAYOUT, [1]).people.values()
    return entry.joints


def known(tmp_path: Path, joints: Any, names: list[str]) -> tuple[int, bool]:
    """Return how many people are known when so many patients taught one joint each, and whether there is a prior."""
    database = Database(tmp_path / "clinic.db")
    with rows_in(database) as rows:
        for number, name in enumerate(names):
            entry = PersonEntry(recordings=1, joints={name: joints[name]}).model_dump(mode="json")
            put_entry(rows.db, rows.patient(f"P-{number}").id, GARMENT.hash, entry, simulated=True)
        session = rows.open_session(rows.patient("P-new", "Otter")).id
    prior = ClinicPrior(database)
    found = prior.people(session, GARMENT), prior.of_others(session, GARMENT) is not None
    database.close()
    return found


def test_four_people_with_another_joint_each_are_no_prior(tmp_path: Path, joints: Any) -> None:
    assert known(tmp_path, joints, sorted(joints)[:4]) == (0, False)


def test_four_people_with_the_same_joint_are(tmp_path: Path, joints: Any) -> None:
    assert known(tmp_path, joints, sorted(joints)[:1] * 4) == (4, True)


def test_so_many_people_that_a_joint_must_have_four_need_no_reading(tmp_path: Path, joints: Any) -> None:
    """The bound that spares the reading is right: one more than three for each joint of the layout."""
    assert known(tmp_path, joints, sorted(joints) * 3) == (0, False)
    (tmp_path / "clinic.db").unlink()
    assert known(tmp_path, joints, [*sorted(joints) * 3, sorted(joints)[0]]) == (3 * len(LAYOUT.joints) + 1, True)
