"""The trials of a person who became better in four sessions, and of four others in whose area nothing changed."""

from typing import Any

import numpy as np
from browser.served.served_clinic import stored
from store.course_of_sessions import store_course

from app.settings import Settings
from app.store.patients import add_patient
from app.store.people import add_clinic
from app.world.floorplan import FloorPlan
from app.world.scene import find_place

PLAN = "apartment"
LENGTH = 13.6  # m
LEVELS = (3.0, 2.4, 2.2, 1.0)  # m2, of the first person's area in each session
TRIALS = 7  # of each session


def measures(rng: np.random.Generator, level: float, *, reached: bool = True) -> dict[str, Any]:
    """Return measures of one trial around a level of the area (m2)."""
    dist = LENGTH * float(np.exp(rng.normal(0.05, 0.02)))
    time = 60.0 * float(np.exp(rng.normal(0.0, 0.1)))
    return {
        "dist": dist,
        "path_length": LENGTH,
        "dist_ratio": dist / LENGTH,
        "e_diff": level * float(np.exp(rng.normal(0.0, 0.12))),
        "cross_track_rms": 0.1 * level * float(np.exp(rng.normal(0.0, 0.12))),
        "time": time,
        "mean_speed": dist / time,
        "stops": int(rng.poisson(2)),
        "collisions": int(rng.poisson(0.5)),
        "sparc": float(rng.normal(-2.4, 0.05)),
        "reached": reached,
    }


def store_better_course(settings: Settings) -> list[int]:
    """Make the clinic with five people; return the ids of the first one's trials, the last of them unfinished."""
    plan = find_place(PLAN)
    assert isinstance(plan, FloorPlan)
    rng = np.random.default_rng(3)
    made: list[int] = []
    with stored(settings) as db:
        clinic = add_clinic(db, "Demonstration")
        for number in range(1, 6):
            patient = add_patient(db, f"P-{number}", "Heron", "")
            levels = LEVELS if number == 1 else (3.0,) * len(LEVELS)
            sessions = [[measures(rng, level) for _ in range(TRIALS)] for level in levels]
            if number == 1:
                sessions[-1].append(measures(rng, 65.0, reached=False))
            ids = store_course(db, clinic.id, patient.id, plan, sessions)
            made = made or ids
    return made
