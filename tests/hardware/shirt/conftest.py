"""A shirt with its far end, open and silent for longer than a verdict needs."""

import pytest
from hardware.shirt.shirts import SILENCE


@pytest.fixture
def opened(tmp_path):
    """Return what makes a shirt with its far end, open and silent for longer than a verdict needs."""
    cases = []

    def make(kind, *arguments, **config):
        case = kind(tmp_path, *arguments, **config)
        cases.append(case)
        case.shirt.open()
        case.clock.time += SILENCE
        return case

    yield make
    for case in cases:
        case.shirt.close()
        case.end()
