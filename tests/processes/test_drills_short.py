"""Each fault drill with few runs, on real processes and sockets; `make drills` runs them in full."""

import asyncio
import random

import pytest
from drills.drills import DRILLS


@pytest.mark.parametrize("name", list(DRILLS))
def test_drill(name):
    drill, _, runs = DRILLS[name]
    result = asyncio.run(drill(runs, random.Random(7)))
    assert result.runs == runs
    assert not result.violations, result.row()
