"""The link and its chair, or a receiver and its sender, for each test."""

import pytest
from hardware.chair.commanded_receiver import CommandedReceiver
from hardware.chair.link_and_chair import LinkAndChair


@pytest.fixture
def pair(tmp_path):
    made = LinkAndChair(tmp_path)
    yield made
    made.close()


@pytest.fixture
def chair():
    return CommandedReceiver()
