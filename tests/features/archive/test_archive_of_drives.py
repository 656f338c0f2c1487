"""Drives of a real chair go with their patient; the chair itself, with its address and key, stays where it is."""

import json
import zipfile
from contextlib import closing
from itertools import islice
from pathlib import Path
from typing import Any

import pytest
from clinic_rows import rows_in
from exported_clinic import make_clinic
from features.archive.archive_clinics import archive_of, bring, empty_clinic
from recorded_trial import record_trial

from app.features.archive.archive_file import PATIENT
from app.features.archive.patient_rows import add_patient_rows, check_rows
from app.recording.reader import read_run
from app.settings import Settings
from app.store.chairs import chairs_of, free_key_ids
from app.store.database import Database
from app.store.drives import drives_of
from app.store.runs import close_run
from app.store.tables import Clinic, PairedChair, PatientSession
from building import make_parameters

DRIVE = "fedcba9876543210fedcba9876543210"
ADDRESS = "chair.riverside.example"


@pytest.fixture(scope="module")
def driven(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """Return the archive of a patient who drove a real chair twice, its hash, and the clinic."""
    settings = make_clinic(tmp_path_factory.mktemp("from"))
    package = settings.state / "heron.zip"
    with rows_in(settings) as clinic:
        clinic.chair("Red", ADDRESS)
        session = clinic.db.get_one(PatientSession, 1)
        for run, distance in ((DRIVE, 12.5), ("0" * 32, None)):
            clinic.drive(session, "by hand", distance, run)
            close_run(clinic.db, run, 100, 0)
    record_trial(settings.runs / DRIVE, make_parameters(), seconds=1.0)
    return package, archive_of(settings, package), settings


def rows_of(package: Path) -> Any:
    with zipfile.ZipFile(package) as opened:
        return json.loads(opened.read(PATIENT))["tables"]


def figures(settings: Settings, patient: int) -> list[Any]:
    with closing(Database(settings.database)) as database, database.transaction() as db:
        return [
            (one.run_id, one.source, one.hash, one.started, one.ended, one.end, one.distance)
            for one in drives_of(db, patient)
        ]


def test_drives_and_their_recordings_come_along_and_go_on_with_the_same_hash(
    driven: Any, other: Settings, tmp_path: Path
) -> None:
    package, digest, first = driven
    patient = bring(other, package).patient_id
    assert figures(other, patient) == figures(first, 1)
    assert [one[-1] for one in figures(other, patient)] == [12.5, None]
    assert read_run(other.runs / DRIVE).damage is None
    assert archive_of(other, tmp_path / "again.zip", patient, "Ben") == digest
    third = empty_clinic(tmp_path / "third")
    again = bring(third, tmp_path / "again.zip").patient_id
    assert figures(third, again) == figures(first, 1)


def test_no_chair_comes_along(driven: Any, other: Settings) -> None:
    document = rows_of(driven[0])
    assert "chair_id" not in document["drive"][0]
    assert ADDRESS not in json.dumps(document)
    bring(other, driven[0])
    with closing(Database(other.database)) as database, database.transaction() as db:
        clinic = db.get_one(Clinic, 1)
        (chair,) = db.query(PairedChair).all()  # one for both drives
        assert (chair.host, chair.port, chair.removed is None) == ("", 0, False)
        assert chairs_of(db) == []
        assert next(free_key_ids(db, clinic)) == 1
        assert chair.key_id not in set(islice(free_key_ids(db, clinic), 20))


def test_a_second_patient_with_drives_refers_to_the_same_chair(driven: Any, other: Settings) -> None:
    rows = rows_of(driven[0])
    rows["patient"][0]["code"] = "P-2"
    for table, column in (("run", "id"), ("trial", "run_id"), ("drive", "run_id")):
        for row in rows[table]:
            row[column] += "-2"
    bring(other, driven[0])
    with closing(Database(other.database)) as database, database.transaction() as db:
        second = add_patient_rows(db, check_rows(rows))
        assert len(drives_of(db, second)) == 2
        assert db.query(PairedChair).count() == 1
