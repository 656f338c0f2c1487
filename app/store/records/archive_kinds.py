"""Which tables the archive of a patient carries, and why it leaves the others out: each table stands in one list."""

from typing import Final

from app.store.records.record_tables import NoteRevision, OutcomeScale, PatientConsent, SessionNote, SessionSignOff
from app.store.sharing.sharing_tables import CommentRevision, MomentComment
from app.store.tables import (
    CalibrationStep,
    Drive,
    InterfaceTest,
    ParameterSet,
    Patient,
    PatientSession,
    Profile,
    Run,
    Table,
    Trial,
)

# Each table after those that it refers to, and the column by which its rows are found: rows of the patient, of the
# patient's sessions, of its profiles, notes, trials, comments.
KINDS: Final[tuple[tuple[type[Table], str], ...]] = (
    (Patient, "id"),
    (PatientSession, "patient_id"),
    (Run, "session_id"),
    (CalibrationStep, "session_id"),
    (Profile, "patient_id"),
    (ParameterSet, "profile_id"),
    (Trial, "patient_id"),
    (Drive, "patient_id"),
    (InterfaceTest, "patient_id"),
    (SessionNote, "session_id"),
    (NoteRevision, "note_id"),
    (OutcomeScale, "session_id"),
    (SessionSignOff, "session_id"),
    (PatientConsent, "patient_id"),
    (MomentComment, "trial_id"),
    (CommentRevision, "comment_id"),
)

LEFT_OUT: Final = {
    "clinic_id": "the clinic that has the rows",
    "folder": "of a recording, which is named by the recording's id",
    "chair_id": "a chair stays in its clinic, with its address and key",
    "person_id": "the people of another clinic do not exist here: the author of a comment goes along by name",
}
"""Columns that do not go along, whichever table has them, each with the reason."""

NOT_IN_ARCHIVE: Final = {
    "comment_reading": "who of this clinic has read a comment; in another clinic nobody has",
    "share_link": "opens records of this clinic's machine, and belongs to who made it",
    "share_visit": "a browser in which a share link of this clinic was opened",
    "patient_screen": "a screen that was paired with this machine for one session",
    "patient_file": "signals that were uploaded to be played; what was recorded of them is a run",
    "patient_import": "where this clinic has the patient from; another clinic notes from whom it has the patient",
    "imported_session": "which sessions came with an archive to this clinic",
    "prior_entry": "computed from accepted calibrations, which go along; another clinic asks for its own consent",
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
    "prior_switch": "a setting of this clinic's owner",
}
"""Every other table, with the reason why the archive of a patient does not have it."""
