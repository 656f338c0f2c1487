"""A patient's course for a benchmark: sessions of seven trials of 40 s, with their recordings."""

import math
import shutil
import uuid
from datetime import timedelta
from pathlib import Path

from app.clock import utc_now
from app.hardware.chair.simulator import VirtualChair
from app.messages import NO_CUE, SensorFrame
from app.pipeline.chain import Chain
from app.pipeline.safety_gate import Conditions
from app.process.ring import TickRing
from app.recording.writer import RunWriter
from app.source import STUDY_SOURCE
from app.store.database import Database
from app.store.parameters import save_parameters, save_profile
from app.store.patients import add_patient
from app.store.people import add_clinic
from app.store.runs import add_run, add_trial, close_run, finish_trial
from app.store.tables import PatientSession
from app.world.scene import find_place
from bench.subject import bench_parameters, bench_signals

TRIALS = 7  # of each session
SECONDS = 40.0  # of each recording
RATE = 100.0  # Hz
PLAN = "apartment"


def store_course(database: Database, runs: Path, sessions: int, seconds: float = SECONDS) -> None:
    """Make a clinic with one patient and store the sessions; each trial has a copy of one recording of `seconds`."""
    plan = find_place(PLAN)
    assert plan is not None
    path, parameters = plan.paths[0], bench_parameters(RATE)
    recorded = runs / "recorded"
    _record(recorded, seconds)
    with database.transaction() as db:
        clinic = add_clinic(db, "Bench")
        patient = add_patient(db, "P-1", "Heron", "")
        now = utc_now()
        for number in range(sessions):
            day = now - timedelta(days=sessions - number)
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
                    patient_id=patient.id,
                    parameters_id=row.id,
                    floorplan=plan.name,
                    floorplan_title=plan.title,
                    path=path.name,
                    path_points=[[x, y] for x, y in path.points],
                )
                close_run(db, name, None, None)
                stored.started = day + timedelta(minutes=trial)
                finish_trial(db, stored.id, "goal", _measures(number * TRIALS + trial))


def _measures(number: int) -> dict[str, float]:
    level = 1 + 3 * math.exp(-number / 20) + 0.2 * math.sin(7.0 * number)
    return {"e_diff": level, "dist": 14 + level, "time": 40 + 20 * level, "sparc": -3 - level, "reached": True}


def _record(folder: Path, seconds: float) -> None:
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
        "floorplan": plan.model_dump(mode="json"),
        "path": plan.paths[0].name,
    }
    ring = TickRing.create(f"bodydrive-bench-{uuid.uuid4().hex}")
    ring.unlink()
    writer = RunWriter(folder, meta, len(layout.channels), len(parameters.gestures))
    writer.start(ring, 0, 1)
    chain.arm()
    conditions = Conditions()
    for number, values in enumerate(bench_signals(parameters, seconds)):
        t = number / RATE
        ring.write(chain.step(SensorFrame(number, t, t, values), t, conditions), 1, t, NO_CUE, 0, 0)
    writer.close(ring.number)
    ring.close()
