"""What is reviewed of an imported patient is what the exporting clinic reviews: learning curve, time lines, replays."""

from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

import pytest
from api.fake_clinic import Clinic
from api.running_app import running
from exported_clinic import MEASURES, RUN, SIMULATED, make_clinic
from features.archive.archive_clinics import bring, empty_clinic
from recorded_trial import plan_of, record_trial, store_trial
from store.known_people import known_clinic

from app.clock import utc_now
from app.features.archive.service import make_archive
from app.recording.recorded_trajectory import read_trajectory
from app.settings import Settings
from app.store.access.sign_ins import sign_in
from app.store.database import Database
from app.store.parameters import current_parameters, save_parameters, save_profile
from app.store.people import add_person
from app.store.runs import close_run
from app.store.tables import PatientSession, Trial
from building import make_parameters

TASK = {"floorplan": "room", "path": "ahead", "source": "simulated"}
OWN_IDS = {"id", "session_id", "patient_id"}  # of the rows of one database
BETWEEN = {"origin", "session"}  # which say that a session was imported, and from where


def run_of(number: int) -> str:
    return f"{number:032x}"


def drive(settings: Settings, session_id: int, numbers: range, plan: Any) -> None:
    """Store and record further trials of a session, each better than the one before it."""
    with closing(Database(settings.database)) as database, database.transaction() as db:
        session = db.get_one(PatientSession, session_id)
        parameters, _ = current_parameters(db, session.patient_id)
        for number in numbers:
            measures = {**MEASURES, "e_diff": 2.0 / number + 0.01 * (number % 3), "time": 12.5 - 0.3 * number}
            store_trial(db, run_of(number), (session, parameters), plan, SIMULATED, measures)
            close_run(db, run_of(number), 200, 0)
    for number in numbers:
        record_trial(settings.runs / run_of(number), make_parameters(), seconds=2.0, seed=number, plan=plan)


@pytest.fixture
def exporting(tmp_path: Path) -> Settings:
    """A clinic whose patient drove fourteen trials in two sessions."""
    settings = make_clinic(tmp_path / "first")
    with closing(Database(settings.database)) as database, database.transaction() as db:
        second = PatientSession(
            clinic_id=1, patient_id=1, number=2, started=utc_now(), ended=utc_now(), accepted=True, version="0.2.0"
        )
        db.add(second)
        db.flush()
        parameters = make_parameters(seed=2)
        save_parameters(db, save_profile(db, 1, second.id, parameters.profile), parameters)
    drive(settings, 1, range(2, 8), plan_of())
    drive(settings, 2, range(8, 15), plan_of())
    return settings


@pytest.fixture
def importing(tmp_path: Path) -> Settings:
    """A clinic with a trial of its own in another place, so that its ids are others."""
    settings = empty_clinic(tmp_path / "second")
    with closing(Database(settings.database)) as database, database.transaction() as db:
        parameters = make_parameters()
        save_parameters(db, save_profile(db, 1, 1, parameters.profile), parameters)
    drive(settings, 1, range(100, 101), plan_of(name="hall"))
    return settings


@contextmanager
def reviewed(settings: Settings) -> Iterator[Clinic]:
    """Open a clinic's pages as somebody who may see everything."""
    for clinic in running(settings):
        with clinic.database.transaction() as db:
            person = add_person(db, known_clinic(db), "Rita", "clinician", None)
            clinic.client.cookies.set("bodydrive_sign_in", sign_in(db, person, "test"))
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
    return {
        "learning": without(learning, OWN_IDS),
        "trials": without(trials, OWN_IDS | BETWEEN),
        "lines": lines,
        "verdicts": [
            {
                **one,
                "earlier": place[one["earlier"]],
                "familiarisation": [place[trial] for trial in one["familiarisation"]],
            }
            for one in verdicts
        ],
    }


def without(value: Any, names: set[str]) -> Any:
    if isinstance(value, dict):
        return {name: without(inner, names) for name, inner in value.items() if name not in names}
    return [without(inner, names) for inner in value] if isinstance(value, list) else value


def test_learning_curve_and_replays_of_an_imported_patient_are_those_of_the_exporting_clinic(
    exporting: Settings, importing: Settings, tmp_path: Path
) -> None:
    package = tmp_path / "heron.zip"
    with closing(Database(exporting.database)) as database:
        make_archive(database, 1, "Ana", exporting.runs, package)
    patient = bring(importing, package).patient_id
    there, here = review_of(exporting, 1), review_of(importing, patient)
    assert len(there["learning"]["trials"]) == len(there["lines"]) == 14
    assert there["learning"]["curves"]
    words = {verdict["word"] for one in there["verdicts"] for verdict in one["verdicts"].values()}
    assert words > {"too few"}
    assert here["learning"] == there["learning"]
    assert here["trials"] == there["trials"]
    assert here["verdicts"] == there["verdicts"]
    assert here["lines"] == there["lines"]
    for run in (RUN, *map(run_of, range(2, 15))):
        mine, theirs = (read_trajectory(one.runs / run) for one in (importing, exporting))
        assert all(
            (mine_column == theirs_column).all() for mine_column, theirs_column in zip(mine, theirs, strict=True)
        )
    with closing(Database(importing.database)) as database, database.transaction() as db:
        ids = {trial.id for trial in db.query(Trial).filter_by(patient_id=patient)}
    assert ids == set(range(2, 16))  # and yet not one id is the same row
