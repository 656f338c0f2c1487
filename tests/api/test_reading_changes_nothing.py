"""Reading changes nothing: no GET of any route leaves another row, file or command behind, apart from the log."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from api.fake_clinic import Clinic
from api.served_routes import requested, routes_of
from sqlalchemy import select

from app.store.tables import Table

# The log of who looked, and what follows from a request as such: when a person was last there, and the clocks.
KEPT_OF_EACH_REQUEST = {"log", "auth_session", "passed_time"}
DATABASE = "bodydrive.sqlite"  # its rows are compared; beside it lies the head of the log
LOOKED_UP = {"heartbeat", "status"}  # what the control process is told or asked all the time


def rows(clinic: Clinic) -> Iterator[tuple[str, list[Any]]]:
    with clinic.database.transaction() as db:
        for name, table in Table.metadata.tables.items():
            if name not in KEPT_OF_EACH_REQUEST:
                yield name, [tuple(row) for row in db.execute(select(table))]


def files(folder: Path) -> dict[str, int]:
    found = (file for file in folder.rglob("*") if file.is_file() and not file.name.startswith(DATABASE))
    return {str(file.relative_to(folder)): file.stat().st_mtime_ns for file in found}


def test_no_get_of_any_route_changes_anything(calibrated: Clinic, trial: int, settings: Any) -> None:
    named = sorted(routes_of(calibrated, {"GET"}))
    assert len(named) > 40
    answered, changed = 0, []
    for name in named:
        before = dict(rows(calibrated)), files(settings.state), len(calibrated.process.calls)
        answer = requested(calibrated, name)
        answered += answer.status_code == 200
        told = [do for do, *_ in calibrated.process.calls[before[2] :] if do not in LOOKED_UP]
        after = dict(rows(calibrated)), files(settings.state)
        if after != before[:2] or told:
            pairs: Any = zip(before[:2], after, strict=True)  # of tables, and of files
            what = [{key for key in {*old, *new} if old.get(key) != new.get(key)} for old, new in pairs]
            changed.append((name, *what, told))
    assert answered > 25
    assert changed == []
