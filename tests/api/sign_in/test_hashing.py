"""The process that hashes passwords: started, used, killed."""

import asyncio
import os
from contextlib import asynccontextmanager

import psutil
import pytest
from argon2 import PasswordHasher, extract_parameters

from app.api.sign_in import hashing
from app.api.sign_in.hashing import Busy, Hashing
from app.api.sign_in.hashing_process import answer
from app.child_process import JsonChild
from app.refusals import Unavailable
from event_loop import in_event_loop


@asynccontextmanager
async def started():
    """Yield what hashes passwords; its process ends afterwards."""
    made = Hashing()
    try:
        yield made
    finally:
        await made.close()


def children():
    found = psutil.Process().children(recursive=True)
    return [child for child in found if "app.api.sign_in.hashing_process" in child.cmdline()]


@in_event_loop
async def test_a_password_is_its_own_and_no_others():
    async with started() as made:
        stored = await made.hash("correct horse battery")
        assert stored.startswith("$argon2id$")
        odd = "äöü \u202e 🦩\n" * 20
        right = ((stored, "correct horse battery"), (await made.hash(odd), odd))
        wrong = ((stored, "another"), (None, "correct horse battery"), ("junk", "x"))
        assert [await made.matches(*one) for one in (*right, *wrong)] == [True, True, False, False, False]


class CountingHasher(PasswordHasher):
    """Counts how often argon2 ran, and with what."""

    def __init__(self):
        super().__init__(time_cost=1, memory_cost=64, parallelism=1)
        self.ran = []

    def hash(self, password, **more):
        self.ran.append((self.time_cost, self.memory_cost, self.parallelism))
        return super().hash(password, **more)

    def verify(self, stored, password):
        used = extract_parameters(stored)
        self.ran.append((used.time_cost, used.memory_cost, used.parallelism))
        return super().verify(stored, password)


def test_somebody_unknown_costs_the_work_of_a_wrong_password():
    hasher = CountingHasher()
    stored = answer(hasher, {"do": "hash", "password": "the right one"})["hash"]
    hasher.ran.clear()
    for kept in (stored, None):
        assert answer(hasher, {"do": "verify", "stored": kept, "password": "a wrong one"}) == {"matches": False}
    known, unknown = hasher.ran
    assert known == unknown


@in_event_loop
async def test_it_gives_way_to_every_other_process_and_ends_with_the_program():
    async with started() as made:
        assert children() == []
        await made.hash("a password")
        (process,) = children()
        assert process.nice() >= min(os.nice(0) + 10, 19)  # nothing is nicer than 19
    assert not process.is_running()


@in_event_loop
async def test_who_asks_at_the_same_time_gets_the_answer_of_the_own_password():
    async with started() as made:
        stored = await made.hash("a password")
        tries = (made.matches(stored, given) for given in ("a password", "another", "a password"))
        assert await asyncio.gather(*tries) == [True, False, True]


@in_event_loop
async def test_one_that_died_is_started_again():
    async with started() as made:
        stored = await made.hash("a password")
        children()[0].kill()
        with pytest.raises(Unavailable, match="try again"):
            await made.matches(stored, "a password")
        assert await made.matches(stored, "a password")


@in_event_loop
async def test_a_machine_without_room_for_another_process_is_a_sentence(monkeypatch):
    async def no_room():
        raise BlockingIOError(11, "Resource temporarily unavailable")

    async with started() as made:
        with monkeypatch.context() as full:
            full.setattr(hashing, "_start", no_room)
            with pytest.raises(Unavailable, match="try again"):
                await made.hash("a password")
        assert await made.hash("a password")


@in_event_loop
async def test_one_that_does_not_answer_is_ended(monkeypatch):
    monkeypatch.setattr(hashing, "ANSWER_LIMIT", 0.2)
    monkeypatch.setattr(hashing, "END_LIMIT", 0.1)
    async with started() as made:
        pipe = asyncio.subprocess.PIPE
        process = await asyncio.create_subprocess_exec("sleep", "60", stdin=pipe, stdout=pipe)
        made._child = JsonChild(process)
        with pytest.raises(Unavailable):
            await made.hash("a password")
        assert process.returncode is not None


@in_event_loop
async def test_whoever_gives_up_leaves_no_answer_for_the_next():
    async with started() as made:
        stored = await made.hash("a password")
        asking = asyncio.create_task(made.matches(stored, "a password"))
        await asyncio.sleep(0)
        asking.cancel()
        await asyncio.gather(asking, return_exceptions=True)
        assert not await made.matches(stored, "another")


@in_event_loop
async def test_there_are_only_so_many_slots(monkeypatch):
    monkeypatch.setattr(hashing, "MOST_AT_ONCE", 1)
    async with started() as made:
        async with made.slot():
            with pytest.raises(Busy):
                async with made.slot():
                    pass
        async with made.slot():
            pass


@in_event_loop
async def test_it_ends_without_a_word_when_the_web_process_is_gone(capfd):
    async with started() as made:
        await made.hash("a password")
        process = made._child._process
        process.stdin.write(b'{"do": "hash", "password": "another"}\n')
        process._transport.get_pipe_transport(1).close()  # as when the one that reads is killed
        process.stdin.close()
        assert await process.wait() == 0
    assert capfd.readouterr().err == ""
