"""The migration that lets a comment have an author elsewhere keeps every comment with its texts and readings."""

import sqlite3
from contextlib import closing
from pathlib import Path
from typing import Any

from exports.exported_clinic import make_clinic

from app.clock import utc_now
from app.store.access.person_tables import Person
from app.store.database import Database, make_engine
from app.store.schema import migrate, revision_of
from app.store.sharing.comments import add_comment, revise_comment
from app.store.sharing.sharing_tables import CommentRevision, MomentComment
from app.store.tables import Trial


def rows(file: Path) -> dict[str, list[Any]]:
    queries = {
        "comment": "SELECT id, clinic_id, trial_id, person_id, t, withdrawn FROM moment_comment",
        "revision": "SELECT * FROM comment_revision",
        "reading": "SELECT * FROM comment_reading",
    }
    with closing(sqlite3.connect(file)) as connection:
        return {name: connection.execute(query).fetchall() for name, query in queries.items()}


def down_to(file: Path, revision: str) -> None:
    engine = make_engine(file)
    while revision_of(file) != revision:
        migrate(engine, "-1")
    engine.dispose()


def test_comments_go_down_and_up_and_those_of_people_elsewhere_go_on_the_way_down(tmp_path: Path) -> None:
    file = make_clinic(tmp_path).database
    now = utc_now()
    with closing(Database(file)) as database:
        with database.transaction() as db:
            person = Person(clinic_id=1, name="Dora", role="reviewer", created=now)
            db.add(person)
            db.flush()
            comment = add_comment(db, db.get_one(Trial, 1), person.id, 2.5, "late")
            revise_comment(db, comment, person.id, "late and far")
        before = rows(file)
        with database.transaction() as db:
            elsewhere = MomentComment(clinic_id=1, trial_id=1, author="Eve", t=1.0)
            db.add(elsewhere)
            db.flush()
            db.add(CommentRevision(comment_id=elsewhere.id, text="from elsewhere", written=now))
    assert [len(found) for found in before.values()] == [1, 2, 0]
    down_to(file, "0017")
    assert rows(file) == before
    Database(file).close()
    assert rows(file) == before
