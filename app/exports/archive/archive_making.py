"""What the archive of a patient is made from, and who may make it."""

from pathlib import Path
from typing import NamedTuple

from app.exports.archive.archive_room import require_room_for
from app.exports.archive.archive_writing import MakeReport, archive_steps
from app.exports.archive.open_archive import open_archive
from app.package import Step
from app.refusals import Conflict
from app.store.consent import require_consent
from app.store.database import Database
from app.store.log import write_log
from app.store.patients import find_patient
from app.store.records.imports import clinic_name
from app.store.records.patient_rows import Rows, patient_rows

OPEN = "A session of this patient is open: end it first, then make the archive."


class ArchiveMaterial(NamedTuple):
    """Everything that the archive of a patient is made from."""

    clinic: str  # its name
    rows: Rows
    folders: list[Path]  # of the recordings

    def steps(self, make_report: MakeReport | None) -> list[Step]:
        """Return the steps that write the archive, to be called one after the other with the file to be made.

        `make_report` returns the report of the patient's course as HTML; None: the archive has no report.
        """
        return archive_steps(self.clinic, self.rows, self.folders, make_report)


def archive_material(
    database: Database, clinic_id: int, patient_id: int, person: str, runs: Path, place: Path
) -> ArchiveMaterial:
    """Return what the archive of a patient is made from; log that `person` makes it, in the folder `place`.

    `runs` is the folder of all recordings. NotFound when there is no such patient; Conflict without consent, or while
    a session of the patient is open; DiskFull when the disk of `place` has no room for it.
    """
    with database.transaction() as db:
        find_patient(db, clinic_id, patient_id)
        require_consent(db, patient_id, "sharing")
        rows = patient_rows(db, patient_id)
        clinic = clinic_name(db, clinic_id)
        if any(row["ended"] is None for row in rows["session"]):
            raise Conflict(OPEN)
        folders = [runs / str(row["id"]) for row in rows["run"]]
        require_room_for(folders, place)
        write_log(db, person, "export", patient=patient_id, session=None, form="archive", runs=len(rows["run"]))
    return ArchiveMaterial(clinic, rows, folders)


def make_archive(
    database: Database,
    clinic_id: int,
    patient_id: int,
    person: str,
    runs: Path,
    package: Path,
    make_report: MakeReport | None = None,
) -> str:
    """Write the archive of a patient to `package` and return its hash; raises what `archive_material` raises."""
    material = archive_material(database, clinic_id, patient_id, person, runs, package.parent)
    for step in material.steps(make_report):
        step(package)
    with open_archive(package) as made:
        return made.listed.hash
