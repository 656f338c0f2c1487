"""`bodydrive prior export` and `import`: out of and into a clinic's folder, and each refusal in one sentence."""

import json
from datetime import date
from pathlib import Path
from typing import Any

import pytest
from calibration.prior.simulated_wearers import prior_of, sleeve
from cli.answers import assert_refused, output_of
from sqlalchemy import event
from sqlalchemy.orm import Session

from app.calibration.prior.documents import OwnPrior, ReleasedPrior
from app.calibration.prior.prior_file import read_prior
from app.features.consents.service import give_consent, withdraw_consent
from app.features.prior.entries import put_entry, switch_prior
from app.refusals import Refusal
from app.session.calibration.garment import Garment
from app.settings import Settings
from app.store.database import Database
from app.store.patients import add_patient
from app.store.people import add_clinic
from app.store.tables import LogEntry, Patient

PEOPLE = 9
DAY = date(2026, 3, 1)
SHIRT = Garment(sleeve(), "worn", None).hash


@pytest.fixture(scope="module")
def own() -> OwnPrior:
    """What nine people add, w1 to w9."""
    return prior_of(range(1, PEOPLE + 1))


class Folder:
    """A clinic of nine patients in a folder; all consent to help other patients."""

    def __init__(self, state: Path) -> None:
        self.settings = Settings(state=state)
        self.settings.state.mkdir()
        self.database = Database(self.settings.database)
        with self.database.transaction() as db:
            add_clinic(db, "Clinic")
            for number in range(1, PEOPLE + 1):
                patient = add_patient(db, f"w{number}", "Heron", "")
                give_consent(db, patient.id, "clinic_prior", DAY, "Ada")

    def fill(self, own: OwnPrior) -> None:
        with self.database.transaction() as db:
            for patient in db.query(Patient):
                put_entry(db, patient.id, SHIRT, own.people[patient.code].model_dump(mode="json"), simulated=False)

    def share(self, *codes: str, withdraw: bool = False) -> None:
        with self.database.transaction() as db:
            for patient in db.query(Patient).filter(Patient.code.in_(codes)):
                if withdraw:
                    withdraw_consent(db, patient.id, "sharing", "Ada")
                else:
                    give_consent(db, patient.id, "sharing", DAY, "Ada")


@pytest.fixture
def clinic(tmp_path: Path, own: OwnPrior) -> Any:
    made = Folder(tmp_path / "clinic")
    made.fill(own)
    (tmp_path / "layout.json").write_text(sleeve().model_dump_json())
    yield made
    made.database.close()


def codes(first: int, last: int) -> list[str]:
    return [f"w{number}" for number in range(first, last + 1)]


def export(bodydrive: Any, out: str, *more: str, state: str = "clinic") -> Any:
    return bodydrive("prior", "export", "--state", state, "--layout", "layout.json", "--out", out, *more)


def test_the_own_prior_goes_out_of_one_folder_and_into_another(
    clinic: Folder, bodydrive: Any, tmp_path: Path, own: OwnPrior
) -> None:
    out = output_of(export(bodydrive, "own.json"))
    assert out == "9 people in own.json, with an entry each: it must not leave the clinic.\n"
    written = read_prior(tmp_path / "own.json")
    assert isinstance(written, OwnPrior)
    assert written.people == own.people
    other = Folder(tmp_path / "new")
    assert bodydrive("prior", "import", "own.json", "--state", "new") == (0, "9 people imported from own.json\n", "")
    export(bodydrive, "again.json", state="new")
    assert read_prior(tmp_path / "again.json") == written
    with other.database.transaction() as db:
        assert "prior imported" in [row.what for row in db.query(LogEntry)]
    other.database.close()


def test_who_withdrew_the_consent_is_not_in_it(clinic: Folder, bodydrive: Any, tmp_path: Path) -> None:
    with clinic.database.transaction() as db:
        withdraw_consent(db, db.query(Patient).filter_by(code="w3").one().id, "clinic_prior", "Ada")
    export(bodydrive, "own.json")
    assert "w3" not in json.loads((tmp_path / "own.json").read_text())["people"]


def test_a_release_holds_sums_over_eight_who_consent_to_sharing(clinic: Folder, bodydrive: Any, tmp_path: Path) -> None:
    clinic.share(*codes(1, 8))
    out = output_of(export(bodydrive, "release.json", "--release"))
    assert out == "8 people in release.json: sums only, which may leave the clinic.\n"
    released = read_prior(tmp_path / "release.json")
    assert isinstance(released, ReleasedPrior)
    assert released.people == 8
    assert '"w1"' not in (tmp_path / "release.json").read_text()


def test_seven_who_consent_to_sharing_are_refused(clinic: Folder, bodydrive: Any, tmp_path: Path) -> None:
    clinic.share(*codes(1, 7))
    assert_refused(
        export(bodydrive, "release.json", "--release"),
        "Sharing outside",
        "there are 7 people in all, and only sums over at least 8 people may leave a clinic",
    )
    assert not (tmp_path / "release.json").exists()


def test_nobody_is_released_twice_also_after_the_prior_moved(clinic: Folder, bodydrive: Any, tmp_path: Path) -> None:
    clinic.share(*codes(1, 8))
    export(bodydrive, "first.json", "--release")
    clinic.share("w9")
    assert_refused(export(bodydrive, "second.json", "--release"), "fewer than 8 are in no release yet")
    export(bodydrive, "own.json")
    other = Folder(tmp_path / "new")
    other.share(*codes(1, 9))
    bodydrive("prior", "import", "own.json", "--state", "new")
    assert_refused(export(bodydrive, "third.json", "--release", state="new"), "fewer than 8 are in no release yet")
    assert not (tmp_path / "third.json").exists()
    other.database.close()


def test_a_release_that_the_clinic_cannot_remember_is_not_left_behind(
    clinic: Folder, bodydrive: Any, tmp_path: Path
) -> None:
    clinic.share(*codes(1, 8))

    def full(_: Session) -> None:
        if (tmp_path / "release.json").exists():
            raise Refusal("The disk is full.")

    event.listen(Session, "before_commit", full)
    try:
        said = export(bodydrive, "release.json", "--release")
    finally:
        event.remove(Session, "before_commit", full)
    assert_refused(said, "The disk is full")
    assert not (tmp_path / "release.json").exists()
    assert export(bodydrive, "release.json", "--release")[0] == 0


def test_a_newer_calibration_of_a_person_stays_as_released(clinic: Folder, bodydrive: Any, own: OwnPrior) -> None:
    clinic.share(*codes(1, 8))
    export(bodydrive, "first.json", "--release")
    clinic.fill(own)
    assert export(bodydrive, "second.json", "--release")[0] == 2


def test_without_consent_to_sharing_and_without_anybody_the_sentence_says_so(clinic: Folder, bodydrive: Any) -> None:
    nobody = "Nobody of the 9 people known in 'sleeve' has consented to"
    assert_refused(export(bodydrive, "release.json", "--release"), nobody)
    with clinic.database.transaction() as db:
        for patient in db.query(Patient):
            withdraw_consent(db, patient.id, "clinic_prior", "Ada")
    assert_refused(export(bodydrive, "own.json"), "Nobody is known in 'sleeve'")


def test_what_cannot_be_imported_is_one_sentence_and_changes_nothing(
    clinic: Folder, bodydrive: Any, tmp_path: Path
) -> None:
    clinic.share(*codes(1, 8))
    export(bodydrive, "release.json", "--release")
    export(bodydrive, "own.json")

    def refused(file: str, words: str, state: str = "new") -> None:
        assert_refused(bodydrive("prior", "import", file, "--state", state), words)

    other = Folder(tmp_path / "new")
    refused("release.json", "is a release, which holds sums and no entries of people")
    refused("missing.json", "missing.json")
    with other.database.transaction() as db:
        patient = db.query(Patient).filter_by(code="w5").one()
        withdraw_consent(db, patient.id, "clinic_prior", "Ada")
    refused(
        "own.json", "the patient 'w5' has not consented to “Use for other patients of the clinic”; nobody was imported"
    )
    with other.database.transaction() as db:
        db.query(Patient).filter_by(code="w5").one().code = "w55"
    refused("own.json", "there is no patient 'w5' in the clinic; nobody was imported")
    with other.database.transaction() as db:
        switch_prior(db, on=False)
    refused("own.json", "switched off")
    other.database.close()
    refused("own.json", "There is no clinic in", "nowhere")
