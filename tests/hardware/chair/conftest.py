"""The link and its chair for each test."""

import pytest
from link_story import Story


@pytest.fixture
def story(tmp_path):
    made = Story(tmp_path)
    yield made
    made.close()
