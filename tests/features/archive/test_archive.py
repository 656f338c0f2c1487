"""An archive brings a whole patient to another clinic, and back again; a wrong one changes nothing."""

import csv
import io
import subprocess
import sys
from contextlib import closing, suppress
from functools import partial
from pathlib import Path

import pytest
from clinic_rows import SIMULATED, rows_in
from exported_clinic import CODE, MEASURES, RUN, make_clinic, material_of
from features.archive.archive_clinics import archive_of, bring, rewrite, state_of

from app.clock import utc_now
from app.csv_cells import SPREADSHEET_BEGIN
from app.features.archive import archive_import, patient_rows
from app.features.archive.archive_file import PATIENT
from app.features.archive.archive_import import import_apart
from app.features.exports.csv_tables import trial_csv
from app.features.log.service import read_log
from app.features.records.service import add_note, add_scale, session_record
from app.features.records.sign_off import sign_off
from app.features.reports.composition import compose
from app.features.reports.material import report_material
from app.features.sharing.stories import story_of
from app.recording.reader import read_run
from app.refusals import Conflict, PatientHere
from app.store import log
from app.store.database import Database
from app.store.learning_trials import counted_trials
from app.store.log import write_log
from app.store.origins import origin_of
from app.store.people import add_clinic
from app.store.tables import InterfaceTest, Patient, PatientSession


@pytest.fixture(scope="module")
def archive(tmp_path_factory):
    """Return the archive of a patient whose session is signed off, and its hash."""
    settings = make_clinic(tmp_path_factory.mktemp("from"))
    package = settings.state / "heron.zip"
    with rows_in(settings) as clinic:
        add_note(clinic.db, 1, "Went well.", "Ana")
        add_scale(clinic.db, 1, "SCIM III", 41.5, utc_now().date())
        sign_off(clinic.db, clinic.db.get_one(PatientSession, 1), "Ana")
    return package, archive_of(settings, package), settings


def test_the_process_of_an_import_gives_the_patient_to_the_clinic_of_who_imports(archive, other, monkeypatch):
    package, _, _ = archive
    monkeypatch.setattr(archive_import, "limit_memory", lambda: None)  # this process goes on
    with closing(Database(other.database)) as database, database.transaction() as db:
        second = add_clinic(db, "Lakeside").id
    found = import_apart(other.database, second, package, "Ben", other.runs, other.state / "unpacked", None)
    with closing(Database(other.database)) as database, database.reading() as db:
        assert db.get_one(Patient, found.patient_id).clinic_id == second


def test_another_clinic_gets_the_same_trials_recordings_and_records_and_returns_the_same_hash(archive, other, tmp_path):
    package, digest, first = archive
    found = bring(other, package)
    assert (found.code, found.is_new) == (CODE, True)
    with rows_in(other) as clinic:
        db = clinic.db
        (trial,) = [one.trial for one in counted_trials(db, found.patient_id, "room", "ahead")]
        assert (trial.measures, trial.source) == (MEASURES, SIMULATED)
        record = session_record(db, trial.session_id)
        written = (record.goal, record.notes[0].text, record.scales[0].total)
        assert written == ("To cross the yard.", "Went well.", 41.5)
        assert record.sign_off is not None
        origin = origin_of(db, trial.session_id)
        assert origin is not None
        assert (origin.clinic, origin.person, origin.archive) == ("Riverside", "Ben", digest)
        assert origin_of(db, 1) is None
        assert read_log(db, 1)[0].what == "archive imported"
    assert archive_of(other, tmp_path / "again.zip", found.patient_id, "Ben") == digest
    for file in (first.runs / RUN).iterdir():
        assert (other.runs / RUN / file.name).read_bytes() == file.read_bytes()
    assert read_run(other.runs / RUN).damage is None


def test_the_story_of_an_imported_session_has_no_stop_of_this_clinic(archive, other, monkeypatch):
    """The hours of the imported session are those of another clinic; somebody else was stopped here meanwhile."""
    found = bring(other, archive[0])
    with closing(Database(other.database)) as database, database.transaction() as db:
        here = db.get_one(PatientSession, 1)
        imported = db.query(PatientSession).filter_by(patient_id=found.patient_id).one()
        here.started, here.ended = imported.started, imported.ended
        monkeypatch.setattr(log, "utc_now", lambda: imported.started)
        write_log(db, "Ben", "stop requested")
        assert [event.person for event in story_of(db, here) if event.kind == "stop"] == ["Ben"]
        assert [event for event in story_of(db, imported) if event.kind == "stop"] == []


def test_exports_and_reports_of_imported_sessions_name_the_clinic_and_who_imported_them(archive, other):
    found = bring(other, archive[0])
    exported = material_of(other, "csv", found.patient_id)
    (row,) = csv.DictReader(io.StringIO(trial_csv(exported, {}).removeprefix(SPREADSHEET_BEGIN)))
    with closing(Database(other.database)) as database:
        report = report_material(database, found.patient_id, None, other, lambda *_: {})
    assert (row["origin_clinic"], row["imported_by"]) == ("Riverside", "Ben")
    today = utc_now().astimezone().date()
    assert row["imported"].startswith(f"{utc_now():%Y-%m-%d}")
    facts = {fact.name: fact.value for fact in compose(report).facts}
    assert facts["Imported"] == f"Session 1 from Riverside, by Ben, {today}"


def test_a_second_import_changes_nothing(archive, other):
    bring(other, archive[0])
    before = state_of(other)
    assert bring(other, archive[0]).is_new is False
    assert state_of(other) == before


def test_a_recording_that_a_killed_import_left_is_in_nobodys_way(archive, other):
    left = other.runs / RUN
    left.mkdir(parents=True)
    (left / "run.parquet").write_bytes(b"half")
    assert bring(other, archive[0]).is_new
    assert read_run(left).damage is None


def test_a_patient_who_is_here_already_is_refused(archive, other):
    _, _, first = archive
    before = state_of(first)
    with pytest.raises(PatientHere, match="=P-1 is in this clinic already, and nothing was imported: replace"):
        bring(first, archive[0])
    assert state_of(first) == before
    with rows_in(other) as clinic:
        clinic.patient(CODE, "Wren")
    with pytest.raises(Conflict, match="belongs to another patient"):
        bring(other, archive[0])


def row_with(table, **values):
    """Return what changes columns of the first row of a table."""
    return lambda tables: tables[table][0].update(values)


def with_test(tables, **changes):
    """Add an interface test."""
    run = {**tables["run"][0], "id": "0" * 32, "kind": "interface_test"}
    tables["run"].append(run)
    row = {name: tables["trial"][0][name] for name in ("patient_id", "session_id", "parameters_id", "started")}
    plan = {"seed": 1, "width": 0.2}
    done = {"id": 1, "number": 1, "run_id": run["id"], "status": "done", "end": "complete", "measures": None}
    tables["interface_test"] = [{**row, **done, "plan": plan, "workload": {"mental": 40}, **changes}]


def path_as_run(tables):
    tables["run"][0]["id"] = tables["trial"][0]["run_id"] = "../../etc"


def changed_recording(contents):
    name = f"runs/{RUN}/run.parquet"
    contents[name] = contents[name][:-1] + b"x"


def bomb(contents):
    contents[PATIENT] = b" " * 30_000_000


WRONG = {
    "a run that is not there": (
        {"patient": row_with("trial", run_id="elsewhere")},
        "refers to a row that is not there",
    ),
    "another type": (
        {"patient": row_with("trial", number=True)},
        r"row 1 of its table 'trial', 'number' is wrong \(should be a valid integer\)",
    ),
    "another column": ({"patient": row_with("session", is_admin=1)}, "columns of its table 'session' are others"),
    "a hidden sign": ({"patient": row_with("patient", pseudonym="He\u202eron")}, "which nobody sees"),
    "other figures of a test": (
        {"patient": partial(with_test, measures={"throughput": "fast"})},
        r"row 1 of its table 'interface_test', 'measures\.",
    ),
    "a workload beyond its scale": (
        {"patient": partial(with_test, workload={"mental": 101})},
        r"'workload\.mental' is wrong \(should be less than or equal to 100\)",
    ),
    "a moment before all years": ({"patient": row_with("session", started="0001-01-01T00:00:00+14:00")}, "is no date"),
    "no profile": (
        {"patient": row_with("profile", document={})},
        r"row 1 of its table 'profile', 'document\.created' is wrong \(Field required\)",
    ),
    "a long code": ({"patient": row_with("patient", code="x" * 65)}, "too long"),
    "a path as a run": ({"patient": path_as_run}, "wrong names"),
    "a path as a name": ({"names": {f"runs/{RUN}/run.json": "runs/../../evil.json"}}, "no archive"),
    "an absolute name": ({"names": {f"runs/{RUN}/run.json": "/tmp/evil"}}, "no archive"),
    "a newer schema": ({"listed": {"schema_version": 2}}, "newer bodydrive"),
    "a wrong hash": ({"listed": {"hash": "0" * 64}}, "was changed or cut"),
    "a changed recording": ({"change": changed_recording}, "was changed or cut"),
    "a bomb": ({"change": bomb}, "was changed or cut"),
}


def test_a_hostile_archive_is_one_sentence_and_changes_nothing(archive, other, tmp_path):
    target = tmp_path / "wrong.zip"
    before = state_of(other)
    for case, (fields, sentence) in WRONG.items():
        rewrite(archive[0], target, **fields)
        with pytest.raises(ValueError, match=sentence) as caught:
            bring(other, target)
        assert "\n" not in str(caught.value), case
        assert state_of(other) == before, case
        assert not (tmp_path / "evil.json").exists(), case


def test_an_archive_of_too_many_rows_is_refused(archive, other, monkeypatch):
    monkeypatch.setattr(patient_rows, "MOST_ROWS", 5)
    before = state_of(other)
    with pytest.raises(ValueError, match="it has more than 5 rows"):
        bring(other, archive[0])
    assert state_of(other) == before


def test_the_archive_that_is_rewritten_for_these_tests_is_imported_when_nothing_is_wrong(archive, other, tmp_path):
    rewrite(archive[0], tmp_path / "right.zip")
    assert bring(other, tmp_path / "right.zip").is_new


def test_an_interface_test_comes_along(archive, other, tmp_path):
    rewrite(archive[0], tmp_path / "test.zip", patient=with_test)
    found = bring(other, tmp_path / "test.zip")
    with closing(Database(other.database)) as database, database.transaction() as db:
        (test,) = db.query(InterfaceTest).all()
        assert (test.patient_id, test.plan["width"], test.run.kind) == (found.patient_id, 0.2, "interface_test")
        assert test.workload == {"mental": 40}


def test_an_archive_cut_anywhere_or_with_a_changed_byte_changes_nothing(archive, other, tmp_path):
    content = archive[0].read_bytes()
    target = tmp_path / "cut.zip"
    before = state_of(other)
    for place in range(1, len(content), len(content) // 23):
        target.write_bytes(content[:place])
        with pytest.raises(ValueError, match=r"cut\.zip"):
            bring(other, target)
    assert state_of(other) == before
    imported = False
    for place in range(11, len(content), len(content) // 23):
        target.write_bytes(content[:place] + bytes([content[place] ^ 0x55]) + content[place + 1 :])
        with suppress(ValueError, Conflict):
            imported = bring(other, target).is_new or imported  # a byte that no reader of zip files uses
    if imported:
        assert read_run(other.runs / RUN).damage is None
    else:
        assert state_of(other) == before


IMPORT = """
import sys
from pathlib import Path
from app import child_process
from app.features.archive.archive_import import import_apart
child_process.MOST_MEMORY = 1_000_000_000
state, package = map(Path, sys.argv[1:])
import_apart(state / "bodydrive.sqlite", 1, package, "Ben", state / "runs", state / "unpacked", None)
"""
LISTS = 20_000_000  # about 1.3 GB in memory, 100 kB in the file


def test_an_archive_that_needs_too_much_memory_is_one_sentence_and_changes_nothing(package, other, tmp_path):
    rewrite(package, tmp_path / "bomb.zip", text=("12.5", f"[{'[],' * LISTS}1]"))
    before = state_of(other)
    assert "because it needs too much memory; nothing was imported." in problem_of(other.state, tmp_path / "bomb.zip")
    assert state_of(other) == before
    assert problem_of(other.state, package) == ""  # the limit leaves enough for a real archive


def problem_of(state: Path, package: Path) -> str:
    """Import an archive in a process with little memory; return the end of what it complains of."""
    command: list[str | Path] = [sys.executable, "-c", IMPORT, state, package]
    ended = subprocess.run(command, check=False, capture_output=True, text=True, timeout=100)
    return ended.stderr.strip().rpartition("\n")[2]
