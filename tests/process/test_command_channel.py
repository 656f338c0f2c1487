"""Commands and answers over a socket pair: the control process never waits and never fails, whatever arrives."""

import asyncio
import json
import socket

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.process.command_channel import LONGEST_LINE, CommandServer, ControlClient, LinkLost, LinkRefused
from app.texts import from_document


@pytest.fixture
def pair():
    ours, theirs = socket.socketpair()
    yield ours, CommandServer(theirs)
    ours.close()
    theirs.close()


def line(**fields):
    return json.dumps(fields).encode() + b"\n"


def answers(ours):
    ours.settimeout(2.0)
    return [json.loads(text) for text in ours.recv(1_000_000).splitlines()]


@given(st.lists(st.integers(1, 60), max_size=30))
@settings(max_examples=50, deadline=None)
def test_lines_are_assembled_from_any_pieces(cuts):
    ours, theirs = socket.socketpair()
    server = CommandServer(theirs)
    sent = [{"id": i, "do": "move", "joints": {"elbow": i / 7}} for i in range(1, 5)]
    content = b"".join(line(**command) for command in sent)
    taken = []
    for cut in [*cuts, len(content)]:
        piece, content = content[:cut], content[cut:]
        if piece:
            ours.sendall(piece)
        taken += server.poll()
    assert taken == sent
    assert not server.closed
    ours.close()
    server.poll()
    assert server.closed
    theirs.close()


def test_no_data_does_not_close_the_channel(pair):
    _, server = pair
    assert server.poll() == []
    assert not server.closed


def test_commands_sent_before_the_end_are_returned(pair):
    ours, server = pair
    ours.sendall(line(id=1, do="stop"))
    ours.close()
    assert server.poll() == [{"id": 1, "do": "stop"}]
    server.poll()
    assert server.closed


@pytest.mark.parametrize(
    "junk", [b"hello\n", b"[1]\n", b"{}\n", b'{"id": "x", "do": 1}\n', b"\xff\xfe\n", b"[" * 100_000 + b"\n", b"\n"]
)
def test_junk_is_refused_and_what_follows_is_done(pair, junk):
    ours, server = pair
    ours.sendall(junk + line(id=3, do="stop"))
    taken = []
    for _ in range(10):
        taken += server.poll()
    assert taken == [{"id": 3, "do": "stop"}]
    refusals = answers(ours)
    assert [refused["ok"] for refused in refusals] == [False]
    assert "This is no command" in str(from_document(refusals[0]["error"]))


def test_a_line_without_end_is_cut_off(pair):
    ours, server = pair
    ours.setblocking(False)
    sent = 0
    while not server.closed and sent < 2 * LONGEST_LINE:
        try:
            sent += ours.send(b"x" * 65_536)
        except BlockingIOError:
            pass
        except OSError:
            break
        server.poll()
    assert server.closed
    assert sent <= LONGEST_LINE + 1_000_000


def test_a_client_that_takes_no_answers_is_cut_off_and_not_waited_for(pair):
    _, server = pair
    for _ in range(100_000):
        server.answer(1, words="x" * 1000)
        if server.closed:
            break
    assert server.closed
    assert server.poll() == []


def test_commands_with_id_0_are_not_answered(pair):
    ours, server = pair
    server.answer(0, a=1)
    server.refuse(0, "No.")
    server.answer(5, a=1)
    assert answers(ours) == [{"id": 5, "ok": True, "a": 1}]


def with_client(story):
    """Make a test of a story about a client and its server."""

    async def told():
        ours, theirs = socket.socketpair()
        server = CommandServer(theirs)
        client = await ControlClient.open(ours)
        try:
            await story(client, server)
        finally:
            await client.close()
            server.close()

    return lambda: asyncio.run(told())


async def polled(server):
    for _ in range(500):
        if commands := server.poll():
            return commands
        await asyncio.sleep(0.002)
    raise AssertionError("no command came")


@with_client
async def test_answers_find_their_calls_in_any_order(client, server):
    calls = [asyncio.create_task(client.call("double", number=n)) for n in (1, 2, 3)]
    commands = []
    while len(commands) < 3:
        commands += await polled(server)
    for command in reversed(commands):
        server.answer(command["id"], result=2 * command["number"])
    assert [(await call)["result"] for call in calls] == [2, 4, 6]


@with_client
async def test_a_refusal_is_raised_with_its_sentence(client, server):
    call = asyncio.create_task(client.call("arm", hash="x"))
    (command,) = await polled(server)
    assert command == {"id": command["id"], "do": "arm", "hash": "x"}
    server.refuse(command["id"], "There is nothing to drive with: calibrate first.")
    with pytest.raises(LinkRefused, match=r"^There is nothing to drive with: calibrate first\.$"):
        await call


@with_client
async def test_a_missing_answer_is_a_lost_link_and_a_late_answer_does_no_harm(client, server):
    with pytest.raises(LinkLost, match="did not answer 'status'"):
        await client.call("status", limit=0.02)
    (command,) = await polled(server)
    server.answer(command["id"])
    call = asyncio.create_task(client.call("status"))
    (command,) = await polled(server)
    server.answer(command["id"], late=0)
    assert (await call)["late"] == 0


@with_client
async def test_a_closed_channel_fails_waiting_and_later_calls(client, server):
    call = asyncio.create_task(client.call("status"))
    await polled(server)
    assert not client.closed
    server.close()
    with pytest.raises(LinkLost):
        await call
    await client.wait_closed()
    assert client.closed
    with pytest.raises(LinkLost):
        client.send("heartbeat", screen_age=0.0)
    with pytest.raises(LinkLost):
        await client.call("status")


@with_client
async def test_values_that_json_does_not_know_are_not_sent(client, server):
    with pytest.raises(ValueError, match="not JSON compliant"):
        client.send("move", joints={"elbow": float("nan")})
