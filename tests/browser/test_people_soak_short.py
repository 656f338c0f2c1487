"""Two rounds of five browsers in one clinic; `make people-soak` lets them work for half an hour."""

from concurrent.futures import ThreadPoolExecutor

import pytest
from soak.people import MOST_GROWTH, work

from needed import need

pytestmark = [pytest.mark.browser, pytest.mark.long]


def test_nothing_of_one_shows_up_at_another_and_one_controls():
    need("chromium", "chromium")
    with ThreadPoolExecutor(1) as pool:  # other tests' browser has an event loop in this thread
        found = pool.submit(work, 1.0).result()
    assert found.errors == []
    assert found.sockets == 0
    assert found.growth < MOST_GROWTH
    assert found.refused >= 8
