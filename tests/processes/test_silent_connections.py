"""Connections that do nothing and uploads of nobody, in a real program with 1,024 descriptors."""

import psutil
import pytest
from drills.connections import DESCRIPTORS, KINDS, MOST_KEPT, connections, few_descriptors, stop, upload_as_nobody


@pytest.fixture(scope="module")
def demo():
    with few_descriptors() as made:
        yield made


@pytest.mark.parametrize("kind", KINDS)
def test_stop_and_a_new_page_come_through_a_thousand_connections_that_do_nothing(demo, kind):
    """1,100 silent connections took all descriptors, and POST Stop was not answered."""
    with demo.socket("live") as live, connections(demo, kind):
        for _ in range(5):
            stop(demo)
        with demo.socket("live") as another:
            another.recv()
        live.recv()  # a page that is open stays
        assert psutil.Process(demo.process.pid).num_fds() < DESCRIPTORS - 100


def test_nothing_is_kept_of_files_that_nobody_may_send(demo):
    """Twenty uploads of somebody who was not signed in kept 1.18 GB of temporary disk."""
    assert upload_as_nobody(demo) < MOST_KEPT
    assert demo.client.get("/equipment").json()["files"] == []
