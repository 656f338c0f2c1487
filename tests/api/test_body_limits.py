"""Who may send a large body is decided before it is read; size, time and number of them are limited."""

import asyncio
import re
from types import SimpleNamespace

import pytest
from fastapi import HTTPException
from hypothesis import given
from hypothesis import strategies as st
from starlette.requests import HTTPConnection

from app.api import body_limits
from app.api.body_limits import BODY_LIMIT, FIRST, LIMITS, MOST_AT_ONCE, SLOWEST, SMALL, Bodies
from app.api.deps import NOBODY
from app.store.database import Database
from folders import ROOT

PIECE = 10_000  # bytes
FILES = "/api/v1/equipment/files"
FORM = {"Content-Type": "multipart/form-data; boundary=x"}


def person(drives=True, locked=False):
    return SimpleNamespace(drives=drives, locked=locked)


class Sent:
    """A request whose body comes in pieces; it counts those that were read."""

    def __init__(self, pieces, length=None, path=FILES):
        headers = [] if length is None else [(b"content-length", str(length).encode())]
        state = SimpleNamespace(parts={Database: None})
        scope = {"type": "http", "path": path, "headers": headers, "app": SimpleNamespace(state=state)}
        self.connection = HTTPConnection(scope)
        self.left = pieces
        self.read = 0

    async def receive(self):
        if self.left is None:
            await asyncio.Event().wait()
        self.left -= 1
        self.read += 1
        return {"type": "http.request", "body": bytes(PIECE), "more_body": self.left > 0}


async def taken(bodies, sent):
    """Read a body; return it and the status of its refusal, 200 when it came."""
    body = bodies.of(sent.connection, sent.receive)
    try:
        await body.begin()
        while (await body.receive())["more_body"]:
            pass
    except HTTPException as refused:
        return body, refused.status_code
    return body, 200


def status(sent, bodies=None):
    return asyncio.run(taken(bodies or Bodies(), sent))[1]


@pytest.fixture
def asks(monkeypatch):
    """Return a function that says who is signed in."""

    def use(who):
        monkeypatch.setattr(body_limits, "find_sign_in", lambda _database, _connection: who)

    use(None)
    return use


@pytest.mark.parametrize(
    ("who", "expected"), [(None, 401), (person(locked=True), 423), (person(drives=False), 403), (person(), 200)]
)
def test_who_may_not_send_a_file_is_refused_before_it_is_read(asks, who, expected):
    """Twenty uploads of nobody kept 1.18 GB of temporary disk for as long as they liked."""
    asks(who)
    announced = Sent(100, length=100 * PIECE)
    assert status(announced) == expected
    assert announced.read == (100 if expected == 200 else 0)
    unannounced = Sent(100)
    assert status(unannounced) == expected
    assert unannounced.read <= (100 if expected == 200 else SMALL // PIECE + 1)


@given(st.integers(1, 400), st.booleans(), st.sampled_from([FILES, "/api/v1/patients", "/api/v1/floorplans"]))
def test_nobody_s_bodies_are_small_and_everybody_s_have_an_end(pieces, announced, path):
    sent = Sent(pieces, length=pieces * PIECE if announced else None, path=path)
    limit = LIMITS.get(path, BODY_LIMIT)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(body_limits, "find_sign_in", lambda _database, _connection: None)
        found = status(sent)
    size = pieces * PIECE
    assert found == (200 if size <= SMALL else 413 if announced and size > limit else 401)
    assert sent.read * PIECE <= SMALL + PIECE


def test_a_few_large_bodies_are_read_at_once(asks):
    asks(person())

    async def all_of_them():
        bodies = Bodies()
        first = [(await taken(bodies, Sent(20)))[0] for _ in range(MOST_AT_ONCE)]
        assert (await taken(bodies, Sent(20)))[1] == 503
        assert (await taken(bodies, Sent(1)))[1] == 200
        first[0].end()
        assert (await taken(bodies, Sent(20)))[1] == 200
        assert (await taken(bodies, Sent(20)))[1] == 503

    asyncio.run(all_of_them())


@pytest.mark.parametrize("length", [10, 60_000])
def test_a_body_that_does_not_come_is_given_up(monkeypatch, length):
    monkeypatch.setattr(body_limits, "FIRST", 0.05)
    assert status(Sent(None, length=length, path="/api/v1/auth/sign-in")) == 408


def test_a_file_may_take_as_long_as_its_length_needs(asks):
    asks(person())
    now = [0.0]
    sent = Sent(None, length=60_000_000)
    bodies = Bodies(now=lambda: now[0])

    async def begun():
        body = bodies.of(sent.connection, sent.receive)
        await body.begin()
        now[0] = FIRST + 60_000_000 / SLOWEST
        with pytest.raises(HTTPException, match="too slowly"):
            await body.receive()

    asyncio.run(begun())


def test_the_routes_keep_it(clinic):
    """In the whole application, as a browser sends it: in pieces whose number nobody announces."""

    def pieces():
        yield b'--x\r\nContent-Disposition: form-data; name="file"; filename="a.csv"\r\n\r\n'
        for _ in range(600):
            yield b"0,1\n" * 25_000

    refused = clinic("POST", "/equipment/files", content=pieces(), headers=FORM)
    assert (refused.status_code, refused.json()["detail"]) == (401, str(NOBODY))
    assert clinic("POST", "/floorplans/check", content=b" " * 100_000).status_code == 401
    assert clinic("POST", "/auth/demo", json={"code": "x" * 100_000}).status_code == 401


def test_the_proxies_of_the_manual_pass_on_what_is_allowed():
    archives = "/api/v1/archives"
    others = max(limit for path, limit in LIMITS.items() if path != archives)
    bytes_of = {"m": 1 << 20, "g": 1 << 30, "MB": 10**6, "GB": 10**9}  # nginx counts in powers of two
    for name, pattern in (
        ("proxy/nginx.conf", r"client_max_body_size (\d+)(\w+);"),
        ("proxy/Caddyfile", r"max_size (\d+)(\w+)"),
        ("administrators.md", r"(?:bodies of |\()(\d+) (MB|GB)(?= \(| for `/api/v1/archives`)"),
    ):
        text = (ROOT / "docs" / name).read_text(encoding="utf-8")
        passed = sorted(int(number) * bytes_of[unit] for number, unit in re.findall(pattern, text))
        assert len(passed) == 2, name
        assert passed[0] >= others, name
        assert passed[1] >= LIMITS[archives], name
