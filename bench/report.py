"""Measures how long a report takes: of a session, and of a course of 40 sessions of seven trials, as PDF and HTML."""

import tempfile
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

from app.clock import MonotonicClock
from app.computing_process import ComputingProcess
from app.features.reports.composition import report_file
from app.features.reports.document import Form
from app.features.reports.service import Subject, exported_material
from app.scoring.verdict.spread import Spread
from app.session.clinic_spread import ClinicSpread, Task
from app.settings import Settings
from app.source import SourceGroup
from app.store.database import Database
from bench.course import SECONDS, TRIALS, store_course
from bench.row import Row

SESSIONS = 40
ROUNDS = 7
REACH = {"session": 1.0, "course": 3.0}  # s


def measure_reports() -> list[Row]:
    """Return how long it takes from the store to the file: of the newest session and of the course."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        settings = Settings(state=Path(folder))
        with closing(Database(settings.database)) as database, closing(ComputingProcess()) as computing:
            store_course(database, settings.runs, SESSIONS)
            for what, session in (("session", SESSIONS), ("course", None)):
                forms: tuple[Form, ...] = ("pdf", "html")
                for form in forms:
                    make = _maker(database, settings, computing, session, form)
                    first, *times = [_seconds(make) for _ in range(1 + ROUNDS)]
                    details = f"of {SESSIONS} sessions with {TRIALS} trials of {SECONDS:.0f} s; the first {first:.2f} s"
                    rows.append(Row(f"report of a {what}, {form}", times, "s", REACH[what], "lower", details))
    return rows


def _maker(
    database: Database, settings: Settings, computing: ComputingProcess, session: int | None, form: Form
) -> Callable[[], None]:
    spread = ClinicSpread(database, computing)

    def spreads_of(floorplan: str, path: str, group: SourceGroup) -> dict[str, Spread]:
        return spread.of_others(Task(floorplan, path, group), 1)

    def make() -> None:
        subject = Subject(1, session)
        material = exported_material(database, settings, subject, form, "bench", spreads_of, for_patient=True)
        computing.ask(report_file, material, form, "a4")

    return make


def _seconds(make: Callable[[], None]) -> float:
    clock = MonotonicClock()
    begun = clock.now()
    make()
    return clock.now() - begun
