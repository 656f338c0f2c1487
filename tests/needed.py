"""What tests need of this machine: where it is missing they are skipped, or fail where nothing may be skipped."""

import os
import shutil
from typing import NoReturn

import pytest


def lacks(sentence: str) -> NoReturn:
    """Skip the test, or let it fail on a machine that must run all of them."""
    if os.environ.get("BODYDRIVE_NO_SKIP") == "1":
        pytest.fail(sentence)
    pytest.skip(sentence)


def need(program: str, package: str) -> str:
    """Return where a program is, of a package of Debian."""
    return shutil.which(program) or lacks(f"there is no {program} here: install Debian's package '{package}'")
