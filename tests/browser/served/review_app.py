"""A clinic with two trials that are over, their recordings made by the real chain; served in a thread of this process.

python tests/browser/served/review_app.py --port 8131
"""

import argparse
import sys
import tempfile
import threading
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # for its own start, outside of the tests

from browser.served.copied_clinic import copied_clinic
from browser.served.served_clinic import ServedClinic
from recorded_trial import record_trial, store_trial

from app.session.recordings import measure_recording
from app.settings import Settings
from app.source import Source
from app.store.database import Database
from app.store.parameters import current_parameters, save_parameters, save_profile
from app.store.patients import add_patient, start_session
from app.store.people import add_clinic
from app.store.runs import close_run
from app.world.floorplan import FloorPlan
from app.world.scene import find_place
from building import make_parameters

CODE = "the-code-of-the-link"
PLAN = "follow_me.easy"  # somebody walks ahead
SECONDS = 24.0
SIMULATED = Source(shirt="simulator", body="person", chair="virtual", simulated=True)


def furnish(settings: Settings) -> list[int]:
    """Make the clinic with its trials; return their ids. To record them takes seconds."""
    return copied_clinic(_record, settings)


def _record(settings: Settings) -> list[int]:
    plan = find_place(PLAN)
    assert isinstance(plan, FloorPlan)
    path = plan.paths[0]
    parameters = make_parameters()
    database = Database(settings.database)
    made = []
    with database.transaction() as db:
        add_clinic(db, "Demonstration")
        patient = add_patient(db, "P-1", "Heron", "")
        session = start_session(db, patient.id)
        save_parameters(db, save_profile(db, patient.id, session.id, parameters.profile), parameters)
        row, _ = current_parameters(db, patient.id)
        for number in (1, 2):
            run = f"run{number}"
            folder = settings.runs / run
            record_trial(folder, parameters, seconds=SECONDS, seed=number, plan=plan, stop_at=15.0)
            measures = measure_recording(folder, plan, path)
            trial = store_trial(db, run, (session, row), plan, SIMULATED, measures)
            close_run(db, run, int(100 * SECONDS), 0)
            made.append(trial.id)
    database.close()
    return made


class ReviewApp(ServedClinic):
    """The application with this clinic."""

    def __init__(self, folder: Path, port: int = 0) -> None:
        settings = Settings(state=folder, demo_code=CODE)
        self.trials = furnish(settings)
        super().__init__(settings, port)
        self.link = f"{self.address}/#demo={CODE}"


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--port", type=int, default=8131)
    running = ReviewApp(Path(tempfile.mkdtemp()), parser.parse_args().port)
    running.start()
    sys.stdout.write(f"{running.link}\n")
    sys.stdout.flush()
    threading.Event().wait()
