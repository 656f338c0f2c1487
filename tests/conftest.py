"""What holds for every test: generated cases without a deadline, the same ones on each run of CI; its own umask."""

import os
from collections.abc import Iterator

import pytest
from hypothesis import settings

settings.register_profile("bodydrive", deadline=None, derandomize=os.environ.get("CI") == "true")
settings.load_profile("bodydrive")


@pytest.fixture(autouse=True)
def _umask() -> Iterator[None]:
    """Take back what a command that ran within the test has set for files that are made after it."""
    before = os.umask(0o022)
    os.umask(before)
    yield
    os.umask(before)
