"""Whatever an archive holds, it is refused in one sentence, or everything that is asked afterwards is answered."""

import copy
import json
import random
import zipfile
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any
from zlib import crc32

import pyarrow.parquet as pq
import pytest
from exported_clinic import RUN
from features.archive.archive_clinics import empty_clinic, rewrite
from features.archive.archive_mutations import mutations, rows_of, whole_clinic
from features.archive.test_imported_review import reviewed

from app.features.archive.archive_import import import_archive
from app.features.archive.patient_rows import Rows, WrongRows, check_rows
from app.recording.format import END_FILE, META_FILE, META_KEY, PARQUET_FILE, end_bytes
from app.refusals import Conflict
from app.store.database import Database
from app.store.keeping.erasure import erase_patient
from app.store.patients import delete_patient, end_session, open_session
from app.store.tables import Trial

TASK = "floorplan=room&path=ahead"
OF_PATIENT = (
    *("maps", "next-task", f"learning?{TASK}&source=simulated", f"trajectories?{TASK}&source=simulated", "quality"),
    *("sessions", "consents", "shares", "archive/room", "report?form=html", "archive", "next-task?source=simulated"),
    *(f"export?form={form}" for form in ("csv", "parquet", "xdf", "bids", "fhir")),
)
OF_TRIAL = ("", "/timeline", "/verdicts", "/comments")
OF_CLINIC = ("/patients", "/attention", "/review/trials", "/log", "/people", "/backups")


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> tuple[Rows, Path]:
    """Return the rows of a patient who has every kind of row, and the archive."""
    settings, package = whole_clinic(tmp_path_factory.mktemp("from"), trials=6)
    return rows_of(settings), package


class Importing:
    """A clinic whose pages are open, to which archives are brought one after the other."""

    def __init__(self, clinic: Any, settings: Any, package: Path, folder: Path) -> None:
        self.clinic, self._settings, self.package, self._target = clinic, settings, package, folder / "changed.zip"
        self._database: Database = clinic.database

    def failures(self, rows: Rows) -> list[str]:
        """Import these rows with the recordings, and return the requests that end in an error of the server."""
        rewrite(self.package, self._target, patient=lambda tables: tables.update(rows))
        try:
            patient = import_archive(self._database, self._target, "Ben", self._settings.runs).patient_id
        except (ValueError, Conflict) as error:
            words = str(error)
            return [] if words.endswith(".") and "\n" not in words else [f"is no sentence: {words}"]
        try:
            return list(self._failures(patient))
        finally:
            with self._database.transaction() as db:
                if open_session(db) is not None:
                    end_session(db)
                delete_patient(db, patient, "The test is over")
            erase_patient(self._database, self._settings, patient, "Ben")

    def _failures(self, patient: int) -> Iterator[str]:
        with self._database.transaction() as db:
            trials = [trial.id for trial in db.query(Trial).filter_by(patient_id=patient)]
            sessions = {trial.session_id for trial in db.query(Trial).filter_by(patient_id=patient)}
        asked: list[tuple[str, str, dict[str, int] | None]] = [("GET", place, None) for place in OF_CLINIC]
        asked += [("GET", f"/patients/{patient}/{what}", None) for what in OF_PATIENT]
        asked += [("GET", f"/trials/{trials[0]}{what}", None) for what in OF_TRIAL if trials]
        asked += [("GET", f"/sessions/{session}{what}", None) for session in sessions for what in ("", "/story")]
        asked += [("POST", "/replays", {"trial": trials[0]})] if trials else []
        asked += [
            ("POST", "/session", {"patient_id": patient}),
            ("GET", "/controls", None),
            ("GET", "/calibration", None),
        ]
        asked += [("POST", "/controls/undo", {}), ("POST", "/controls/redo", {}), ("POST", "/session/end", {})]
        for method, path, body in asked:
            answer = self.clinic(method, path, **({} if body is None else {"json": body}))
            if answer.status_code >= 500:
                yield f"{method} {path}: {answer.status_code}"


@pytest.fixture
def importing(made: tuple[Rows, Path], tmp_path: Path) -> Iterator[Importing]:
    settings = empty_clinic(tmp_path / "second")
    with reviewed(settings) as clinic:
        yield Importing(clinic, settings, made[1], tmp_path)


def test_what_is_not_changed_is_imported_and_answered(made: tuple[Rows, Path], importing: Importing) -> None:
    assert importing.failures(made[0]) == []


@pytest.mark.parametrize(
    ("checked", "imported"), [(300, 4), pytest.param(10_000, 150, marks=pytest.mark.long)], ids=["some", "all"]
)
def test_each_change_is_refused_or_everything_is_answered_afterwards(
    made: tuple[Rows, Path], importing: Importing, checked: int, imported: int
) -> None:
    """Of several thousand changes those that are taken are imported, as many as there is time for."""
    every = list(mutations(made[0]))
    dice = random.Random(46)
    taken = []
    for words, make in dice.sample(every, min(checked, len(every))):
        if not refused(words, make()):
            taken.append((words, make))
    failures = [f"{words}: {failure}" for words, make in taken[:imported] for failure in importing.failures(make())]
    assert failures == []


@pytest.mark.parametrize("table", ["trial", "drive", "interface_test"])
def test_an_end_that_no_trial_drive_or_test_has_is_refused(made: tuple[Rows, Path], table: str) -> None:
    """A report had no words for the end "3" of an interface test, and answered 500."""
    rows = copy.deepcopy(made[0])
    rows[table][0]["end"] = "3"
    assert refused(f"{table}.0.end", rows)


def refused(words: str, rows: Rows) -> bool:
    """Return whether rows are refused, in one sentence with the table and the field; nothing else may be raised."""
    with suppress(WrongRows):
        check_rows(rows)
        return False
    with pytest.raises(WrongRows) as caught:
        check_rows(rows)
    said = str(caught.value)
    assert len(said) < 500, words
    assert said.isprintable(), words
    return True


HEADERS: tuple[dict[str, Any], ...] = (
    *({}, {"layout": None}, {"sample_rate": "fast"}, {"sample_rate": 1e300}, {"gestures": {}}, {"gestures": ["x"]}),
    *({"cues": [1]}, {"software": []}, {"kind": {}}, {"path": ["x"]}, {"parameters": []}, {"floorplan": 3}),
    *({"parameters": {}}, {"floorplan": {"name": "x"}}, {"dynamics": []}, {"clinic": "x"}, {"source": 1}, {"more": {}}),
)


@pytest.mark.parametrize(
    "headers",
    [random.Random(46).sample(HEADERS, 7), pytest.param(HEADERS, marks=pytest.mark.long)],
    ids=["some", "all"],
)
def test_a_recording_with_another_header_is_refused_or_answered(
    made: tuple[Rows, Path], importing: Importing, tmp_path: Path, headers: Sequence[dict[str, Any]]
) -> None:
    with zipfile.ZipFile(made[1]) as opened:
        opened.extractall(tmp_path / "taken")
    folder = tmp_path / "taken" / "runs" / RUN
    table = pq.read_table(folder / PARQUET_FILE)
    known = json.loads((folder / META_FILE).read_bytes())
    importing.package = tmp_path / "header.zip"
    wrong = {}
    for header in headers:
        meta = json.dumps({**known, **header} if header else {}).encode()
        pq.write_table(table.replace_schema_metadata({META_KEY: meta}), folder / PARQUET_FILE)
        content = (folder / PARQUET_FILE).read_bytes()
        ends = end_bytes(table.num_rows, 0, {META_FILE: crc32(meta), PARQUET_FILE: crc32(content)})
        files = {PARQUET_FILE: content, META_FILE: meta, END_FILE: ends}
        rewrite(made[1], importing.package, files={f"runs/{RUN}/{name}": each for name, each in files.items()})
        if failures := importing.failures(made[0]):
            wrong[str(header)] = failures
    assert wrong == {}
