"""What is reviewed of an imported patient is what the exporting clinic reviews: learning curve, time lines, replays."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from api.fake_clinic import Clinic
from api.running_app import running
from clinic_rows import rows_in
from exported_clinic import MEASURES, RUN, make_clinic
from features.archive.archive_clinics import archive_of, bring, empty_clinic
from recorded_trial import record_trial

from app.recording.recorded_trajectory import read_trajectory
from app.settings import Settings
from app.store.tables import PatientSession, Trial
from building import make_parameters, plan_of

TASK = {"floorplan": "room", "path": "ahead", "source": "simulated"}
OWN_IDS = {"id", "session_id", "patient_id"}  # of the rows of one database
BETWEEN = {"origin", "session"}  # which say that a session was imported, and from where


def run_of(number: int) -> str:
    return f"{number:032x}"


def drive(settings: Settings, session_id: int, numbers: range, plan: Any) -> None:
    """Store and record further trials of a session, each better than the one before it."""
    with rows_in(settings) as clinic:
        session = clinic.db.get_one(PatientSession, session_id)
        for number in numbers:
            measures = {**MEASURES, "e_diff": 2.0 / number + 0.01 * (number % 3), "time": 12.5 - 0.3 * number}
            clinic.trial(session, measures, plan=plan, run=run_of(number), ticks=200, end="by hand")
    for number in numbers:
        record_trial(settings.runs / run_of(number), make_parameters(), seconds=2.0, seed=number, plan=plan)


@pytest.fixture
def exporting(tmp_path: Path) -> Settings:
    """A clinic whose patient drove fourteen trials in two sessions."""
    settings = make_clinic(tmp_path / "first")
    with rows_in(settings) as clinic:
        clinic.map(clinic.session(1, version="0.2.0"), make_parameters(seed=2))
    drive(settings, 1, range(2, 8), plan_of())
    drive(settings, 2, range(8, 15), plan_of())
    return settings


@pytest.fixture
def importing(tmp_path: Path) -> Settings:
    """A clinic with a trial of its own in another place, so that its ids are others."""
    settings = empty_clinic(tmp_path / "second")
    with rows_in(settings) as clinic:
        clinic.map(clinic.db.get_one(PatientSession, 1), make_parameters())
    drive(settings, 1, range(100, 101), plan_of(name="hall"))
    return settings


@contextmanager
def reviewed(settings: Settings) -> Iterator[Clinic]:
    """Open a clinic's pages as somebody who may see everything."""
    for clinic in running(settings):
        clinic.client.cookies.update(clinic.cookies_of("Rita", "clinician"))
        yield clinic


def review_of(settings: Settings, patient: int) -> dict[str, Any]:
    """Return all that is answered of a patient's trials, without the ids of this database."""
    with reviewed(settings) as clinic:
        learning = clinic.good("GET", f"/patients/{patient}/learning", params=TASK)
        trials = [clinic.good("GET", f"/trials/{row['id']}") for row in learning["trials"]]
        lines = [clinic.good("GET", f"/trials/{row['id']}/timeline") for row in learning["trials"]]
        verdicts = [clinic.good("GET", f"/trials/{row['id']}/verdicts") for row in learning["trials"]]
        place = {row["id"]: number for number, row in enumerate(learning["trials"])} | {None: None}
        for row in learning["trials"]:
            assert clinic("POST", "/replays", json={"trial": row["id"]}).status_code == 201
    for one in verdicts:
        one["earlier"] = place[one["earlier"]]
        one["familiarisation"] = [place[trial] for trial in one["familiarisation"]]
    learnt = {"learning": without(learning, OWN_IDS), "trials": without(trials, OWN_IDS | BETWEEN)}
    return {**learnt, "lines": lines, "verdicts": verdicts}


def without(value: Any, names: set[str]) -> Any:
    if isinstance(value, dict):
        return {name: without(inner, names) for name, inner in value.items() if name not in names}
    return [without(inner, names) for inner in value] if isinstance(value, list) else value


def test_learning_curve_and_replays_of_an_imported_patient_are_those_of_the_exporting_clinic(
    exporting: Settings, importing: Settings, tmp_path: Path
) -> None:
    package = tmp_path / "heron.zip"
    archive_of(exporting, package)
    patient = bring(importing, package).patient_id
    there, here = review_of(exporting, 1), review_of(importing, patient)
    assert len(there["learning"]["trials"]) == len(there["lines"]) == 14
    assert there["learning"]["curves"]
    words = {verdict["word"] for one in there["verdicts"] for verdict in one["verdicts"].values()}
    assert words > {"too few"}
    assert here == there
    for run in (RUN, *map(run_of, range(2, 15))):
        mine, theirs = (read_trajectory(one.runs / run) for one in (importing, exporting))
        assert all((column == same).all() for column, same in zip(mine, theirs, strict=True))
    with rows_in(importing) as clinic:
        ids = {trial.id for trial in clinic.db.query(Trial).filter_by(patient_id=patient)}
    assert ids == set(range(2, 16))  # and yet not one id is the same row
