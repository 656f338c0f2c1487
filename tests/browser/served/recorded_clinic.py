"""Clinics with trials that are over, served in a thread of this process; each is made once for all tests of a process.

python tests/browser/served/recorded_clinic.py --port 8131
python tests/browser/served/recorded_clinic.py --course --port 8132
"""

import argparse
import atexit
import shutil
import sys
import tempfile
import threading
from collections.abc import Callable
from functools import cache
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # for its own start, outside of the tests

from browser.served.course_trials import store_better_course
from browser.served.served_clinic import ServedClinic, stored
from recorded_trial import record_trial, store_trial

from app.session.recordings import measure_recording
from app.settings import Settings
from app.source import Source
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
Make = Callable[[Settings], list[int]]
"""Makes a clinic, and returns the ids of its trials."""


def furnish(settings: Settings) -> list[int]:
    """Make a clinic with two recorded trials, and return their ids; to record them takes seconds, once."""
    return copied(store_recorded, settings)


def furnish_course(settings: Settings) -> list[int]:
    """Make a clinic with a course of sessions; return the ids of its first person's trials, the last unfinished."""
    return copied(store_better_course, settings)


def copied(make: Make, settings: Settings) -> list[int]:
    """Copy the clinic that `make` makes into the folder of a test, and return the ids of its trials."""
    folder, trials = _made(make)
    shutil.copytree(folder, settings.state, dirs_exist_ok=True)
    return list(trials)


@cache
def _made(make: Make) -> tuple[Path, list[int]]:
    folder = Path(tempfile.mkdtemp())
    atexit.register(shutil.rmtree, folder)
    return folder, make(Settings(state=folder))


def store_recorded(settings: Settings) -> list[int]:
    """Make a clinic with two trials whose recordings are made by the real chain, and return their ids."""
    plan = find_place(PLAN)
    assert isinstance(plan, FloorPlan)
    parameters = make_parameters()
    made = []
    with stored(settings) as db:
        add_clinic(db, "Demonstration")
        patient = add_patient(db, "P-1", "Heron", "")
        session = start_session(db, patient.id)
        save_parameters(db, save_profile(db, patient.id, session.id, parameters.profile), parameters)
        row, _ = current_parameters(db, patient.id)
        for number in (1, 2):
            run = f"run{number}"
            folder = settings.runs / run
            record_trial(folder, parameters, seconds=SECONDS, seed=number, plan=plan, stop_at=15.0)
            measures = measure_recording(folder, plan, plan.paths[0])
            made.append(store_trial(db, run, (session, row), plan, SIMULATED, measures).id)
            close_run(db, run, int(100 * SECONDS), 0)
    return made


class RecordedClinic(ServedClinic):
    """The application with such a clinic; `trials` are their ids, and `link` signs a browser in."""

    def __init__(self, folder: Path, port: int = 0, make: Make = furnish) -> None:
        settings = Settings(state=folder, demo_code=CODE)
        self.trials = make(settings)
        super().__init__(settings, port)
        self.link = f"{self.address}/#demo={CODE}"


def course_clinic(folder: Path, port: int = 0) -> RecordedClinic:
    """Return the application with a clinic whose first person became better in four sessions."""
    return RecordedClinic(folder, port, furnish_course)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--port", type=int, default=8131)
    parser.add_argument("--course", action="store_true", help="a course of four sessions, without recordings")
    given = parser.parse_args()
    with RecordedClinic(Path(tempfile.mkdtemp()), given.port, furnish_course if given.course else furnish) as running:
        sys.stdout.write(f"{running.link}\n")
        sys.stdout.flush()
        threading.Event().wait()
