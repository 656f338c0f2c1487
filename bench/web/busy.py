"""Measures Stop on the tablet while the web process is busy, and while it is not, on one machine."""

import random
from collections.abc import Callable
from pathlib import Path

import numpy as np

from app.clock import MonotonicClock, monotonic
from bench.children import ask, started
from bench.row import Row
from bench.web.clinic import furnish_clinic, furnish_course
from bench.web.stop import request, served

SIGN_INS = 40  # at once
RUNS, ROUNDS, STOPS = 3, 6, 40  # runs; rounds without and with work in each, in turn; stops in each round
REACH_FLOOD, REACH_PAGES = 2.0, 1.5  # the largest ratio of the two p99
SETTLING = 0.5  # s after the work began or ended
PAUSE = (0.005, 0.03)  # s between two stops, random, so that stops meet every phase of the work


def measure_flood(runs: int = RUNS, rounds: int = ROUNDS, stops: int = STOPS, sign_ins: int = SIGN_INS) -> list[Row]:
    """Return the p99 of the time of `POST /control/stop` with sign-ins under way, divided by the p99 without."""
    what = f"Stop with {sign_ins} sign-ins under way: p99 over that without"
    return [_row(what, REACH_FLOOD, "bench.processes.sign_ins", lambda _: [str(sign_ins)], runs, rounds, stops)]


def measure_first_pages(runs: int = RUNS, rounds: int = ROUNDS, stops: int = STOPS) -> list[Row]:
    """Return the same ratio while pages are opened for which the computing process has to start and load libraries."""
    what = "Stop while pages are opened for the first time: p99 over that without"
    return [_row(what, REACH_PAGES, "bench.processes.first_pages", furnish_clinic, runs, rounds, stops)]


def measure_records(runs: int = RUNS, rounds: int = ROUNDS, stops: int = STOPS) -> list[Row]:
    """Return the same ratio while a report of a course and an export are made, and a review is opened."""
    what = "Stop while a report, an export and a review are made: p99 over that without"
    return [_row(what, REACH_PAGES, "bench.processes.first_pages", furnish_course, runs, rounds, stops)]


def _row(
    what: str,
    reach: float,
    program: str,
    prepare: Callable[[Path], list[str]],
    runs: int,
    rounds: int,
    stops: int,
) -> Row:
    """Measure with the work of a program that is told `on` and `off`.

    Its arguments are the port, and what `prepare` returns for the folder of the clinic, which is empty.
    """
    with served(prepare) as (_, _, port, arguments), started(program, str(port), *arguments) as work:
        try:
            times = in_turn(MonotonicClock(), runs * rounds, stops, port, lambda word: ask(work, word))
            answers = ask(work, "off")
        finally:
            work.communicate()
    quiet, busy = (1e3 * np.array(times[word]) for word in ("off", "on"))
    p99 = [float(np.percentile(found, 99)) for found in (quiet, busy)]
    ratios = [
        float(np.percentile(under, 99) / np.percentile(without, 99))
        for without, under in zip(np.split(quiet, runs), np.split(busy, runs), strict=True)
    ]
    details = (
        f"{runs} runs of {rounds * stops} stops each; p99 {p99[1]:.1f} ms against {p99[0]:.1f} ms, "
        f"median {np.median(busy):.1f} against {np.median(quiet):.1f} ms, "
        f"worst {busy.max():.1f} against {quiet.max():.1f} ms; answers to the others by status: {answers}"
    )
    return Row(what, ratios, "x", reach, "lower", details)


def in_turn(
    clock: MonotonicClock, rounds: int, stops: int, port: int, notify: Callable[[str], str]
) -> dict[str, list[float]]:
    """Return how long each stop took (s), without the work ("off") and with it ("on")."""
    pause = random.Random(1)
    times: dict[str, list[float]] = {"off": [], "on": []}
    for word in ("off", "on") * rounds:
        notify(word)
        clock.sleep_until(clock.now() + SETTLING)
        for _ in range(stops):
            before = request(("127.0.0.1", port), "POST", "/api/v1/control/stop")
            times[word].append(monotonic() - before)
            clock.sleep_until(clock.now() + pause.uniform(*PAUSE))
    return times
