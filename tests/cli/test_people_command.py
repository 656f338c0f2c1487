"""`bodydrive people`: list, invite, disable and enable, with and without a running program."""

import json
from contextlib import contextmanager

import pytest
from cli.answers import assert_refused, output_of

from app.cli import clinic_folder
from app.cli.clinic_folder import FolderInUseError, lock_folder
from app.store.access.invitations import accept_invitation, find_invited
from app.store.access.rights import people_of
from app.store.access.sign_ins import sign_in, signed_in
from app.store.database import Database
from app.store.patients import add_patient
from app.store.people import add_clinic, add_person, find_person, the_clinic
from app.store.tables import LogEntry

ADDRESS = "http://127.0.0.1:9321/"


@pytest.fixture
def database(tmp_path):
    """Return the open database of a clinic with the owner Ada."""
    opened = Database(tmp_path / "clinic" / "bodydrive.sqlite")
    with opened.transaction() as db:
        clinic = add_clinic(db, "Clinic")
        add_person(db, clinic, "Ada", "owner", "a hash")
        add_patient(db, "P-1", "Heron", "")
    yield opened
    opened.close()


@contextmanager
def served(folder):
    """Hold a clinic's folder as a running program does."""
    with lock_folder(folder) as write_address:
        write_address(ADDRESS)
        yield


def people(bodydrive, *words):
    return bodydrive("people", *words, "--state", "clinic")


def test_a_reviewer_of_one_patient_is_invited_and_listed(bodydrive, database):
    out = output_of(people(bodydrive, "invite", "Rita", "--role", "reviewer", "--patient", "P-1"))
    assert "start it with `bodydrive serve`" in out
    link = next(line for line in out.splitlines() if line.startswith("http"))
    with database.transaction() as db:
        assert find_invited(db, link.partition("#invite=")[2]).name == "Rita"
        logged = [(row.person, row.what) for row in db.query(LogEntry)]
        assert logged[-2:] == [("command line", "person added"), ("command line", "invitation made")]
    listed = json.loads(people(bodydrive, "list", "--json")[1])["people"]
    assert listed == [
        {"name": "Ada", "role": "owner", "patients": None, "state": "active"},
        {"name": "Rita", "role": "reviewer", "patients": ["P-1"], "state": "invited"},
    ]
    assert "Rita  reviewer   invited  patients: P-1" in people(bodydrive, "list")[1]


def test_an_owner_who_is_locked_out_gets_a_new_password_while_the_program_runs(bodydrive, database, tmp_path):
    with served(tmp_path / "clinic"):
        code, out, _ = people(bodydrive, "invite", "Ada")
    link = next(line for line in out.splitlines() if line.startswith("http"))
    assert (code, link.startswith(f"{ADDRESS}#invite=")) == (0, True)
    assert "does not run" not in out
    with database.transaction() as db:
        accept_invitation(db, find_invited(db, link.partition("#invite=")[2]), "another hash")
        assert [(one.name, one.role, one.password_hash) for one in people_of(db)] == [("Ada", "owner", "another hash")]


def test_disabling_ends_sign_ins_while_the_program_runs(bodydrive, database, tmp_path):
    with database.transaction() as db:
        token = sign_in(db, add_person(db, the_clinic(db), "Ben", "clinician", "a hash"), "test")
    with served(tmp_path / "clinic"):
        code, out, _ = people(bodydrive, "disable", "Ben")
    assert (code, "within 5 seconds" in out) == (0, True)
    with database.transaction() as db:
        assert signed_in(db, token) is None
    assert people(bodydrive, "enable", "Ben")[0] == 0
    with database.transaction() as db:
        assert find_person(db, "Ben").disabled is None
        assert signed_in(db, token) is None


def test_what_cannot_be_done_is_one_sentence_and_changes_nobody(bodydrive, database):
    for words, sentence in (
        (["disable", "Ada"], "No other owner than Ada can sign in"),
        (["disable", "Nobody"], "There is nobody called 'Nobody'"),
        (["invite", "Ben", "--role", "king"], "--role king is no role"),
        (["invite", "Ben", "--role", "reviewer", "--patient", "P-9"], "--patient P-9: there is no patient"),
        (["invite", "Ben", "--patient", "P-1"], "Patients are chosen for reviewers only"),
        (["invite", "a\u202eb"], "This name cannot be used"),
    ):
        assert_refused(people(bodydrive, *words), sentence)
    with database.transaction() as db:
        assert [(one.name, one.disabled) for one in people_of(db)] == [("Ada", None)]


def test_without_a_clinic_or_beside_a_program_of_another_version_nothing_is_touched(
    bodydrive, database, tmp_path, monkeypatch
):
    assert "There is no clinic in" in bodydrive("people", "list", "--state", "nowhere")[2]
    monkeypatch.setattr("app.store.schema.revision_of", lambda _file: "9999")
    with served(tmp_path / "clinic"):
        assert_refused(people(bodydrive, "list"), "another version")


def test_a_second_program_leaves_the_address_of_the_first_one_in_the_locked_file(tmp_path):
    with served(tmp_path):
        with pytest.raises(FolderInUseError) as refused, lock_folder(tmp_path):
            pass
        assert refused.value.address == ADDRESS
        assert (tmp_path / clinic_folder.IN_USE).read_text() == ADDRESS
