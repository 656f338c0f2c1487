"""The link and its chair for each test."""

import pytest
from hardware.chair.link_and_chair import LinkAndChair


@pytest.fixture
def pair(tmp_path):
    made = LinkAndChair(tmp_path)
    yield made
    made.close()
