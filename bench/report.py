"""Measures how long a report takes: of a session, and of a course of 40 sessions of seven trials, as PDF and HTML."""

import math
import shutil
import tempfile
import uuid
from collections.abc import Callable
from contextlib import closing
from datetime import timedelta
from pathlib import Path

from app.clock import MonotonicClock, utc_now
from app.computing_process import ComputingProcess
from app.hardware.chair.simulator import VirtualChair
from app.messages import NO_CUE, SensorFrame
from app.pipeline.chain import Chain
from app.pipeline.safety_gate import Conditions
from app.process.ring import TickRing
from app.recording.writer import RunWriter
from app.reports.document import Form
from app.reports.rendering import report_file
from app.reports.report_making import Subject, exported_material
from app.scoring.verdict.spread import Spread
from app.session.clinic_spread import ClinicSpread, Task
from app.settings import Settings
from app.source import STUDY_SOURCE, SourceGroup
from app.store.database import Database
from app.store.parameters import save_parameters, save_profile
from app.store.patients import add_patient
from app.store.people import add_clinic
from app.store.runs import add_run, add_trial, finish_trial
from app.store.tables import PatientSession
from app.world.scene import find_place
from bench.row import Row
from bench.subject import bench_parameters, bench_signals

SESSIONS, TRIALS = 40, 7
SECONDS = 40.0  # of each recording
RATE = 100.0  # Hz
ROUNDS = 7
REACH = {"session": 1.0, "course": 3.0}  # s
PLAN = "apartment"


def measure_reports() -> list[Row]:
    """Return how long it takes from the store to the file: of the newest session and of the course."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        settings = Settings(state=Path(folder))
        with closing(Database(settings.database)) as database, closing(ComputingProcess()) as computing:
            _furnish(database, settings.runs)
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
        return spread.of_others(Task(1, floorplan, path, group), 1)

    def make() -> None:
        material = exported_material(database, settings, Subject(1, 1, session), form, "bench", spreads_of)
        computing.ask(report_file, material, form, "a4")

    return make


def _seconds(make: Callable[[], None]) -> float:
    clock = MonotonicClock()
    begun = clock.now()
    make()
    return clock.now() - begun


def _furnish(database: Database, runs: Path) -> None:
    """Store a patient's sessions; each trial has a copy of one recording."""
    plan = find_place(PLAN)
    assert plan is not None
    path, parameters = plan.paths[0], bench_parameters(RATE)
    recorded = runs / "recorded"
    _record(recorded)
    with database.transaction() as db:
        clinic = add_clinic(db, "Bench")
        patient = add_patient(db, clinic.id, "P-1", "Heron", "")
        now = utc_now()
        for number in range(SESSIONS):
            day = now - timedelta(days=SESSIONS - number)
            session = PatientSession(
                clinic_id=clinic.id, patient_id=patient.id, number=number + 1, started=day, ended=day, accepted=True
            )
            db.add(session)
            db.flush()
            if not number:
                row = save_parameters(db, save_profile(db, patient.id, session.id, parameters.profile), parameters)
            for trial in range(TRIALS):
                name = f"{number}-{trial}"
                shutil.copytree(recorded, runs / name)
                stored = add_trial(
                    db,
                    run=add_run(db, name, session.id, "drive", name, STUDY_SOURCE),
                    clinic_id=clinic.id,
                    patient_id=patient.id,
                    parameters_id=row.id,
                    floorplan=plan.name,
                    floorplan_title=plan.title,
                    path=path.name,
                    path_points=[[x, y] for x, y in path.points],
                )
                stored.started = day + timedelta(minutes=trial)
                finish_trial(db, stored.id, "goal", _measures(number * TRIALS + trial))


def _measures(number: int) -> dict[str, float]:
    level = 1 + 3 * math.exp(-number / 20) + 0.2 * math.sin(7.0 * number)
    return {"e_diff": level, "dist": 14 + level, "time": 40 + 20 * level, "sparc": -3 - level, "reached": True}


def _record(folder: Path) -> None:
    """Record one drive as the control process does."""
    plan = find_place(PLAN)
    assert plan is not None
    parameters = bench_parameters(RATE)
    chain = Chain(RATE, parameters, VirtualChair(plan, plan.paths[0].start, "unicycle"))
    layout = parameters.profile.layout
    meta = {
        "run_id": folder.name,
        "kind": "drive",
        "layout": layout.model_dump(mode="json"),
        "sample_rate": RATE,
        "gestures": [gesture.name for gesture in parameters.gestures],
        "cues": [],
        "parameters": parameters.model_dump(mode="json"),
    }
    ring = TickRing.create(f"bodydrive-bench-{uuid.uuid4().hex}")
    ring.unlink()
    writer = RunWriter(folder, meta, len(layout.channels), len(parameters.gestures))
    writer.start(ring, 0, 1)
    chain.arm()
    conditions = Conditions()
    for number, values in enumerate(bench_signals(parameters, SECONDS)):
        t = number / RATE
        ring.write(chain.step(SensorFrame(number, t, t, values), t, conditions), 1, t, NO_CUE, 0, 0)
    writer.close(ring.number)
    ring.close()
