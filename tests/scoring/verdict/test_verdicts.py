"""The verdicts of a task: who becomes worse is found in each measure that is asked for, and in no other."""

import numpy as np

from app.scoring.verdict.verdicts import task_verdicts

SESSIONS = 14
TRIALS = 6  # of each session, of which the first three are for getting used to the task
WORSE_FROM = 8


def rows() -> list[dict[str, object]]:
    """Return the trials of a person whose time and area double in session 8."""
    rng = np.random.default_rng(4)
    made: list[dict[str, object]] = []
    for session in range(1, SESSIONS + 1):
        level = 2.0 if session >= WORSE_FROM else 1.0
        for place in range(TRIALS):
            number = len(made) + 1
            values = {name: level * float(np.exp(rng.normal(0, 0.1))) for name in ("time", "e_diff")}
            facts = {"id": number, "number": number, "session": session, "reached": True, "familiarisation": place < 3}
            made.append({**facts, **values})
    return made


def test_a_deterioration_is_looked_for_in_the_named_measures_only() -> None:
    every = task_verdicts(rows(), {})
    assert set(every.deterioration) == {"time", "e_diff"}
    assert every.deterioration["time"].startswith(f"Worse than this person's own noise since session {WORSE_FROM}.")
    for names in ((), ("time",), ("time", "sparc")):
        found = task_verdicts(rows(), {}, names)
        assert found.sessions == every.sessions
        assert found.deterioration == {name: every.deterioration[name] for name in names if name == "time"}
