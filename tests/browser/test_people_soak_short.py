"""Two rounds of five browsers in one clinic; `make people-soak` lets them work for half an hour."""

import os
import shutil
from concurrent.futures import ThreadPoolExecutor

import pytest
from soak.people import MOST_GROWTH, work

pytestmark = [pytest.mark.browser, pytest.mark.long]


def test_nothing_of_one_shows_up_at_another_and_one_controls():
    if shutil.which("chromium") is None:
        if os.environ.get("BODYDRIVE_NO_SKIP") == "1":
            pytest.fail("there is no chromium here: install Debian's package 'chromium'")
        pytest.skip("there is no chromium here: install Debian's package 'chromium' to run the browser tests")
    with ThreadPoolExecutor(1) as pool:  # other tests' browser has an event loop in this thread
        found = pool.submit(work, 1.0).result()
    assert found.errors == []
    assert found.sockets == 0
    assert found.growth < MOST_GROWTH
    assert found.refused >= 8
