"""A loop that takes commands, and a chair for it."""

import pytest
from hardware.chair.chair_stand_in import StandInChair
from pipeline.commanded_loop import CommandedLoop


@pytest.fixture
def control():
    made = CommandedLoop()
    yield made
    made.close()


@pytest.fixture
def chair(tmp_path):
    made = StandInChair(tmp_path)
    yield made
    made.close()
