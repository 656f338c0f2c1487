"""The export of a patient over the API: streamed, logged, and with consent only."""

import io
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pyarrow.parquet as pa_parquet
import pytest
from recorded_trial import record_trial
from session.same_process import SameProcess

from app.api import package_download
from app.recording.reader import read_run
from app.session.trial import TrialFlow
from app.store.files.temporary_folders import bytes_in
from app.store.tables import Trial
from building import make_parameters


@pytest.fixture
def driven(calibrated: Any) -> Any:
    """A clinic with one finished trial and its recording."""
    calibrated.start_trial()
    calibrated.folder = calibrated.parts[TrialFlow].current.run.folder
    calibrated.end_trial()
    record_trial(calibrated.folder, make_parameters(n_channels=8), seconds=2.0)
    calibrated.patient = calibrated.patient["id"]
    return calibrated


def test_an_export_is_streamed_with_consent_only_and_logged(driven: Any) -> None:
    address = f"/patients/{driven.patient}/export?form=parquet"
    assert "has not consented to sharing outside the clinic" in driven.refused(409, "GET", address)
    with driven.rows() as rows:
        rows.consent(driven.patient, "sharing")
        run = rows.db.query(Trial).one().run_id
    word = "word-of-this-export"
    assert driven.good("GET", "/exports", params={"course": word}) is None
    answer = driven("GET", address, params={"form": "parquet", "course": word})
    assert (answer.status_code, answer.headers["content-type"]) == (200, "application/zip")
    course = driven.good("GET", "/exports", params={"course": word})
    runs = course["recordings"]
    assert course == {"packed": runs, "recordings": runs, "sent": len(answer.content), "state": "complete"}
    assert driven("GET", "/exports", params={"course": "Short!"}).status_code == 422
    with zipfile.ZipFile(io.BytesIO(answer.content)) as opened:
        assert opened.testzip() is None
        names = [name for name in opened.namelist() if name.endswith("drive.parquet")]
        times = pa_parquet.read_table(io.BytesIO(opened.read(names[0])))["run_t"].to_numpy()
    assert times.tolist() == read_run(driven.folder).columns["run_t"].tolist()
    assert run == driven.folder.name
    (row,) = [row for row in driven.log() if row.what == "export"]
    assert (row.details["patient"], row.details["form"]) == (driven.patient, "parquet")
    assert list(driven.folder.parent.parent.glob(".export-*")) == []


def test_an_export_takes_as_long_as_it_writes(driven: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """A recording of 8 h needs more than the limit of a question: the bytes that are written count as its progress."""
    grown: list[bool] = []

    class Watched(SameProcess):
        def ask_while(self, progress: Callable[[], Any], question: Callable[[], Any]) -> Any:
            before = progress()
            answer = super().ask_while(progress, question)
            grown.append(progress() > before)
            return answer

        def ask(self, *_given: Any, **_named: Any) -> Any:
            raise AssertionError("A question like this has a limit.")

    with driven.rows() as rows:
        rows.consent(driven.patient, "sharing")
    monkeypatch.setattr(package_download, "ComputingProcess", Watched)
    answer = driven("GET", f"/patients/{driven.patient}/export?form=csv")
    with zipfile.ZipFile(io.BytesIO(answer.content)) as opened:
        assert opened.testzip() is None
    assert len(grown) > 1  # the tables, and each recording
    assert all(grown)


def test_the_bytes_of_all_parts_are_its_progress(tmp_path: Path) -> None:
    (tmp_path / "part").mkdir()
    (tmp_path / "part" / "a").write_bytes(b"12")
    (tmp_path / "export.zip").write_bytes(b"3")
    assert bytes_in(tmp_path) == 3


def test_a_patient_or_session_that_is_not_there_is_not_exported(driven: Any) -> None:
    assert driven("GET", "/patients/999/export?form=csv").status_code == 404
    assert driven("GET", f"/patients/{driven.patient}/export?form=mat").status_code == 422


def test_the_web_process_loads_no_library_of_an_export() -> None:
    script = (
        "import sys, app.api.package_download, app.features.archive.service;"
        "sys.exit(any(name in sys.modules for name in ('pyarrow', 'scipy', 'sklearn')))"
    )
    assert subprocess.run([sys.executable, "-c", script], check=False).returncode == 0
