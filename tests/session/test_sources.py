"""The sources of recordings: in older databases and recordings, and in words."""

import json
from pathlib import Path
from typing import Any

import pytest
from sqlalchemy import text

from app.hardware.registry import BODIES, CHAIRS, SHIRTS
from app.source import BODY_WORDS, CHAIR_WORDS, SHIRT_WORDS, UNKNOWN_SOURCE, Source, source_of_header, source_words
from app.store.database import Database, make_engine
from app.store.schema import migrate
from app.store.tables import Profile, Run, Trial

OLD_RUNS = {  # id: when it began, and what the log tells of that time
    "first": ("2025-01-01 10:00:00", ("simulator", "person", True)),
    "moved": ("2025-01-02 10:00:00", ("simulator", "visitor", True)),
    "worn": ("2025-01-03 10:00:00", ("udp", None, False)),
    "real": ("2025-01-03 11:00:00", ("udp", None, False)),
    "played": ("2025-01-04 10:00:00", ("replay", None, True)),
    "again": ("2025-01-05 10:00:00", ("simulator", "person", True)),
}
CHOICES = [
    ("2025-01-02 09:00:00", "body chosen", {"kind": "visitor"}),
    ("2025-01-03 09:00:00", "shirt chosen", {"kind": "udp"}),
    ("2025-01-04 09:00:00", "shirt chosen", {"kind": "replay"}),
    ("2025-01-05 09:00:00", "shirt chosen", {"kind": "simulator"}),
]


def insert(connection: Any, table: str, **values: Any) -> None:
    names = ", ".join(values)
    marks = ", ".join(f":{name}" for name in values)
    connection.execute(text(f"INSERT INTO {table} ({names}) VALUES ({marks})"), values)


def old_database(file: Path) -> None:
    """Make a database of the version before, with a patient, runs, a map, a trial, a drive and a log."""
    engine = make_engine(file)
    migrate(engine, "0005")
    at = "2025-01-01 09:00:00"
    with engine.begin() as connection:
        insert(connection, "clinic", id=1, name="Old", created=at, unused="[]")
        insert(connection, "patient", id=1, clinic_id=1, code="P-1", pseudonym="Heron", note="", created=at)
        insert(connection, "session", id=1, clinic_id=1, patient_id=1, number=1, started=at, accepted=1)
        for name, (started, _known) in OLD_RUNS.items():
            insert(connection, "run", id=name, session_id=1, kind="drive", folder=name, started=started)
        for version, created in ((1, "2025-01-01 11:00:00"), (2, "2025-01-03 09:30:00")):
            insert(
                connection, "profile", id=version, patient_id=1, session_id=1, version=version, document="{}",
                created=created,
            )  # fmt: skip
        insert(
            connection, "parameters", id=1, profile_id=1, title="S", settings="{}", hash="0", created=at, current=1,
            abandoned=0,
        )  # fmt: skip
        trial = {"clinic_id": 1, "patient_id": 1, "session_id": 1, "parameters_id": 1, "floorplan": "a", "path": "b"}
        trial |= {"floorplan_title": "A", "path_points": "[]", "started": at, "status": "done", "kept": 1}
        for number, run in enumerate(("first", "worn"), start=1):
            insert(connection, "trial", id=number, run_id=run, number=number, end="goal", measures="{}", **trial)
        insert(connection, "chair", id=1, clinic_id=1, name="Blue", host="h", port=1, key_id=1, speeds="{}", paired=at)
        insert(
            connection, "drive", id=1, clinic_id=1, patient_id=1, session_id=1, run_id="real", chair_id=1,
            parameters_id=1, hash="0", started=at,
        )  # fmt: skip
        for number, (when, what, details) in enumerate(CHOICES, start=1):
            insert(
                connection, "log", id=number, at=when, person="Ada", what=what, details=json.dumps(details),
                previous_hash="", hash="",
            )  # fmt: skip
    engine.dispose()


def test_an_older_database_tells_its_sources_by_its_log_and_goes_down_again(tmp_path: Path) -> None:
    file = tmp_path / "old.sqlite"
    old_database(file)
    database = Database(file)
    with database.transaction() as db:
        found = {run.id: (run.shirt, run.body, run.simulated) for run in db.query(Run)}
        chairs = {run.id: run.chair for run in db.query(Run)}
        maps = {profile.version: profile.simulated for profile in db.query(Profile)}
        groups = {trial.run_id: trial.run.source.group for trial in db.query(Trial)}
    database.close()
    assert found == {name: known for name, (_started, known) in OLD_RUNS.items()}
    assert (chairs["first"], chairs["real"], chairs["played"]) == ("virtual", "udp", "unknown")
    assert maps == {1: True, 2: False}
    assert groups == {"first": "simulated", "worn": "worn"}
    engine = make_engine(file)
    with engine.connect() as connection:
        while connection.execute(text("SELECT version_num FROM alembic_version")).scalar_one() > "0005":
            connection.rollback()
            migrate(engine, "-1")
        kept = connection.execute(text("SELECT id, folder FROM run ORDER BY started")).all()
        assert [tuple(row) for row in kept] == [(name, name) for name in OLD_RUNS]
        assert connection.execute(text("SELECT count(*) FROM trial")).scalar_one() == 2
    engine.dispose()


def test_every_source_declares_whether_it_is_simulated_and_has_its_words() -> None:
    assert all(isinstance(driver.simulated, bool) for driver in SHIRTS.values())
    assert {kind for kind, driver in SHIRTS.items() if driver.simulated} == {"simulator", "replay"}
    assert set(SHIRT_WORDS) == set(SHIRTS)
    assert set(BODY_WORDS) == set(BODIES)
    assert set(CHAIR_WORDS) == {*CHAIRS, "unknown"}


@pytest.mark.parametrize(
    ("source", "words"),
    [
        (Source(shirt="simulator", body="person", chair="virtual", simulated=True),
         "Simulated shirt (simulated person), virtual chair: practice only"),
        (Source(shirt="replay", body=None, chair="virtual", simulated=True),
         "Recorded signals, virtual chair: practice only"),
        (Source(shirt="udp", body=None, chair="udp", simulated=False), "Worn shirt, real chair"),
        (Source(shirt="new", body=None, chair="virtual", simulated=False), "Shirt of the kind 'new', virtual chair"),
        (UNKNOWN_SOURCE, "Shirt not recorded, chair not recorded"),
    ],
)  # fmt: skip
def test_a_source_is_said_in_words(source: Source, words: str) -> None:
    assert source_words(source) == words


def test_the_header_of_a_recording_tells_its_source_and_an_older_one_its_chair_only() -> None:
    source = Source(shirt="udp", body=None, chair="virtual", simulated=False)
    assert source_of_header({"source": source.model_dump(mode="json"), "dynamics": None}) == source
    assert source_of_header({}) == UNKNOWN_SOURCE
    assert source_of_header({"dynamics": "unicycle"}).chair == "virtual"
    assert source_of_header({"dynamics": None}).chair == "udp"
    assert source_of_header({"source": {"shirt": 7}, "dynamics": None}).simulated is None
