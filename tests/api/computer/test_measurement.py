"""The measurement of "This computer": a real process of its own, and the answers of the open screens."""

import asyncio
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import pytest
from api.fake_clinic import Clinic, is_news, next_message

from app.api.computer import graphics
from app.api.computer.measurement import BUSY, FAILED, INTERRUPTED, UNDER_WAY


class Asked:
    """A measurement that is asked for in another thread."""

    def __init__(self, clinic: Clinic, seconds: int) -> None:
        self._answer: Any = None

        def ask() -> None:
            self._answer = clinic("POST", "/computer/measurement", json={"seconds": seconds})

        self._thread = threading.Thread(target=ask)
        self._thread.start()

    def answer(self) -> Any:
        self._thread.join(50)
        return self._answer


@pytest.fixture
def started(monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[], asyncio.subprocess.Process]]:
    """Return what waits until a process measures, and returns it."""
    found: list[asyncio.subprocess.Process] = []
    is_there = threading.Event()
    start = asyncio.create_subprocess_exec

    async def remembered(*words: Any, **more: Any) -> asyncio.subprocess.Process:
        found.append(await start(*words, **more))
        is_there.set()
        return found[-1]

    monkeypatch.setattr(asyncio, "create_subprocess_exec", remembered)

    def wait() -> asyncio.subprocess.Process:
        assert is_there.wait(50)
        return found[-1]

    yield wait
    assert all(process.returncode is not None for process in found)


@contextmanager
def open_socket(clinic: Clinic, path: str) -> Iterator[Any]:
    with clinic.socket(path) as socket:
        socket.receive_json()
        yield socket


def test_it_says_what_the_command_says_and_each_screen_draws(paired: Clinic, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(graphics, "ANSWER_LIMIT", 2.0)
    with (
        open_socket(paired, "/live") as page,
        open_socket(paired, "/live"),  # answers nothing, as a page that is out of view
        open_socket(paired, "/patient/live") as screen,
    ):
        asked = Asked(paired, 1)
        for socket in (page, screen):
            next_message(socket, is_news("graphics"))
        for pictures in (-1.0, 58.4):  # nonsense changes nothing
            page.send_json({"pictures": pictures})
        screen.send_json({"pictures": 12})
        answer = asked.answer()
    assert answer.status_code == 200, answer.text
    machine, screens = answer.json()["machine"], answer.json()["screens"]
    words = " ".join(finding["message"] for finding in machine["findings"])
    assert "Of 100 ticks of the control loop" in words
    assert "Port 8080 is the one of this clinic" in words
    assert all(word in words for word in ("eal-time", "emory", "GB of the disk", "The clock shows"))
    assert machine["message"].startswith("This computer is")
    verdicts = {finding["verdict"] for finding in machine["findings"]}
    assert machine["verdict"] == next(one for one in ("bad", "attention", "good") if one in verdicts)
    assert [one["verdict"] for one in screens] == ["good", "attention", "attention"]
    assert screens[0]["message"] == "The page of Demo clinician draws 58 pictures a second."
    assert "did not answer" in screens[1]["message"]
    assert screens[2]["message"].startswith("A patient's screen draws 12 pictures a second. ")


def test_it_ends_when_a_chair_is_armed_and_does_not_begin_before_the_end_of_that(
    calibrated: Clinic, started: Callable[[], asyncio.subprocess.Process]
) -> None:
    asked = Asked(calibrated, 60)
    process = started()
    assert calibrated.refused(409, "POST", "/computer/measurement", json={"seconds": 1}) == str(UNDER_WAY)
    calibrated.start_trial()
    first = asked.answer()
    assert (first.status_code, first.json()["detail"]) == (409, str(INTERRUPTED))
    assert process.returncode is not None
    assert calibrated.refused(409, "POST", "/computer/measurement", json={"seconds": 1}) == str(BUSY)


def test_a_process_that_cannot_measure_is_one_sentence(signed_in: Clinic, monkeypatch: pytest.MonkeyPatch) -> None:
    for program in ("/bin/false", "/nowhere/python"):
        monkeypatch.setattr(sys, "executable", program)
        assert signed_in.refused(503, "POST", "/computer/measurement", json={"seconds": 1}) == str(FAILED)


def test_how_long_is_bounded(signed_in: Clinic) -> None:
    for seconds in (0, 61, 1.5, "10", None):
        assert signed_in("POST", "/computer/measurement", json={"seconds": seconds}).status_code == 422, seconds
