"""Each fault drill with few runs, on real processes and sockets; `make drills` runs them in full.

Drills that judge how quickly a loaded web process answers need a quiet machine: only `make drills` runs them.
"""

import asyncio
import random

import pytest
from drills.drills import DRILLS

OF_ANSWERS = {"sign-ins", "uploads", "second-socket", "large-plan"}
NAMES = [pytest.param(name, marks=[pytest.mark.long] if name in OF_ANSWERS else []) for name in DRILLS]


@pytest.mark.parametrize("name", NAMES)
def test_drill(name):
    drill, _, runs = DRILLS[name]
    result = asyncio.run(drill(runs, random.Random(7)))
    assert result.runs == runs
    assert not result.violations, result.row()
