"""The page for who walks beside a chair that is measured: what it serves, and its Stop."""

import http.client
import json

import pytest

from app.hardware.chair.chair_measure import _page_at
from app.hardware.chair.receive import CannotStart
from app.hardware.chair.walker_page import FILES, WalkerMoment, WalkerPage


@pytest.fixture
def page():
    made = WalkerPage("127.0.0.1", 0)
    yield made
    made.close()


def ask(page, method, path):
    host, _, port = page.address.removeprefix("http://").rstrip("/").rpartition(":")
    connection = http.client.HTTPConnection(host, int(port), timeout=30)
    connection.request(method, path)
    answer = connection.getresponse()
    content = answer.read().decode()
    connection.close()
    return answer, content


def test_it_serves_itself_and_what_happens_now(page):
    for path, (kind, content) in FILES.items():
        answer, came = ask(page, "GET", path)
        assert (answer.status, came) == (200, content)
        assert answer.headers["Content-Type"] == f"{kind}; charset=utf-8"
        assert answer.headers["Content-Security-Policy"].startswith("default-src 'self'")
    page.moment = WalkerMoment("IT MOVES", "Walk beside it.")
    assert json.loads(ask(page, "GET", "/state")[1]) == page.moment._asdict()
    assert ask(page, "GET", "/none")[0].status == 404


def test_stop_is_taken_once_and_nothing_else_stops(page):
    assert not page.take_stop()
    for method, path in (("GET", "/stop"), ("POST", "/"), ("POST", "/state")):
        assert ask(page, method, path)[0].status == 404
    assert not page.take_stop()
    assert ask(page, "POST", "/stop")[0].status == 200
    assert page.take_stop()
    assert not page.take_stop()


class FakeOutput:
    """An output that says whether it was released."""

    is_closed = False

    def close(self):
        self.is_closed = True


def test_without_its_address_it_is_one_sentence_and_the_output_is_released(page):
    port = int(page.address.rstrip("/").rpartition(":")[2])
    for place in (("127.0.0.1", port), ("no such host", 80)):
        output = FakeOutput()
        with pytest.raises(CannotStart, match="choose another --page") as refused:
            _page_at(place, output)
        assert "\n" not in str(refused.value)
        assert output.is_closed
    assert _page_at(None, output) is None
