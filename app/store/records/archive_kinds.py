"""Which tables the archive of a patient carries, and why it leaves the others out: each table stands in one list."""

from collections.abc import Mapping
from functools import cache
from typing import Final

from app.features.registration import ArchivedTable, features
from app.store.tables import (
    CalibrationStep,
    Drive,
    InterfaceTest,
    ParameterSet,
    Patient,
    PatientSession,
    Profile,
    Run,
    Trial,
)

KERNEL: Final = (
    ArchivedTable(Patient, "id"),
    ArchivedTable(PatientSession, "patient_id"),
    ArchivedTable(Run, "session_id"),
    ArchivedTable(CalibrationStep, "session_id"),
    ArchivedTable(Profile, "patient_id"),
    ArchivedTable(ParameterSet, "profile_id"),
    ArchivedTable(Trial, "patient_id"),
    ArchivedTable(Drive, "patient_id"),
    ArchivedTable(InterfaceTest, "patient_id"),
)
"""Each table after those that it refers to."""

LEFT_OUT: Final = {
    "clinic_id": "the clinic that has the rows",
    "folder": "of a recording, which is named by the recording's id",
    "chair_id": "a chair stays in its clinic, with its address and key",
    "person_id": "the people of another clinic do not exist here: the author of a comment goes along by name",
}
"""Columns that do not go along, whichever table has them, each with the reason."""

NOT_IN_ARCHIVE: Final = {
    "patient_screen": "a screen that was paired with this machine for one session",
    "patient_file": "signals that were uploaded to be played; what was recorded of them is a run",
    "patient_import": "where this clinic has the patient from; another clinic notes from whom it has the patient",
    "imported_session": "which sessions came with an archive to this clinic",
    "incident_patient": "a mark of this clinic's owner, under which nothing is erased here",
    "incident": "concerns the machine of this clinic; its own archive is made by another command",
    "erased_patient": "patients that this clinic has erased; it has no word about a person",
    "last_id": "ids that this database gives to no second row",
    "log": "the chain of who did what in this clinic; rows taken out of it could not be verified",
    "clinic": "this clinic and its equipment",
    "person": "the people of this clinic",
    "auth_session": "sign-ins of people of this clinic",
    "known_browser": "browsers of people of this clinic",
    "invitation": "invitations of people of this clinic",
    "chair": "real chairs of this clinic",
    "record_keeping": "settings of this clinic's owner",
    "made_backup": "backups of this clinic",
    "passed_time": "what the clocks of this clinic's machine said",
}
"""The other tables of the kernel, with the reason why the archive of a patient does not have them."""


@cache
def archived_tables() -> tuple[ArchivedTable, ...]:
    """Return the tables that an archive carries, those of features last."""
    return (*KERNEL, *(table for one in features().values() for table in one.archived))


def not_archived() -> Mapping[str, str]:
    """Return every other table by its name, with the reason."""
    return NOT_IN_ARCHIVE | {table: why for one in features().values() for table, why in one.not_archived.items()}
