"""A clinic of people with a course of four sessions, one of whom became worse; its replaced files can be put back."""

import io

import numpy as np
from browser.eyes.eyes_clinic import EyesClinic
from browser.served.course_trials import PLAN, TRIALS, measures
from browser.served.recorded_clinic import furnish_course
from browser.served.served_clinic import stored
from store.course_of_sessions import store_course

from app.settings import Settings
from app.store.patients import add_patient
from app.world.floorplan import FloorPlan
from app.world.scene import find_place

BETTER, WORSE = 1, 6  # ids of the patients whose newest session is better, and worse, than the sessions before
LEVELS = (1.0, 1.0, 3.0, 3.2)  # m2, of the second one's area in each session
ROOM = {
    "name": "ward-3",
    "title": "Ward 3",
    "walls": [[[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [0.0, 4.0], [0.0, 0.0]]],
    "paths": [{"name": "main", "title": "Across", "points": [[1.0, 2.0], [5.0, 2.0]], "instruction": "Go."}],
}


class CourseClinic(EyesClinic):
    """The application of this clinic; `trials` are those of the patient who became better."""

    def _furnish(self, settings: Settings) -> list[int]:
        trials = furnish_course(settings)
        plan = find_place(PLAN)
        assert isinstance(plan, FloorPlan)
        rng = np.random.default_rng(4)
        with stored(settings) as db:
            patient = add_patient(db, f"P-{WORSE}", "Kingfisher", "")
            assert patient.id == WORSE
            store_course(db, 1, patient.id, plan, [[measures(rng, level) for _ in range(TRIALS)] for level in LEVELS])
        return trials

    def _admit(self) -> None:
        """Replace a file of recorded signals and a floor plan; everybody is here already."""
        for number in (1, 2):
            file = ("walk.csv", io.BytesIO(f"t,a\n0,{number}\n".encode()), "text/csv")
            for where, body in (
                ("/equipment/files", {"files": {"file": file}}),
                ("/floorplans", {"json": {**ROOM, "title": f"Ward {number}"}}),
            ):
                answer = self.client.request("POST", f"{where}?same_name=replace", **body)
                assert answer.is_success, answer.text

    def session(self, number: int) -> int:
        """Return the id of this session of the patient who became better."""
        sessions = self.good("GET", f"/patients/{BETTER}/sessions")
        return int(next(one["id"] for one in sessions if one["number"] == number))
