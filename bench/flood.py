"""Measures Stop on the tablet while 40 people sign in, and without them, on one machine."""

import random
from collections.abc import Callable

import numpy as np

from app.clock import MonotonicClock, monotonic
from bench.children import ask, started
from bench.row import Row
from bench.stop import request, served

SIGN_INS = 40  # at once
RUNS, ROUNDS, STOPS = 3, 6, 40  # runs; rounds without and with sign-ins in each, in turn; stops in each round
REACH = 2.0  # the largest ratio of the two p99
SETTLING = 0.5  # s after the flood began or ended
PAUSE = (0.005, 0.03)  # s between two stops, random, so that stops meet every phase of the sign-ins


def measure_flood(runs: int = RUNS, rounds: int = ROUNDS, stops: int = STOPS, sign_ins: int = SIGN_INS) -> list[Row]:
    """Return the p99 of the time of `POST /control/stop` with sign-ins under way, divided by the p99 without."""
    with served() as (_, _, port), started("bench.processes.sign_ins", str(port), str(sign_ins)) as flood:
        try:
            times = _in_turn(MonotonicClock(), runs * rounds, stops, port, lambda word: ask(flood, word))
            answers = ask(flood, "off")
        finally:
            flood.communicate()
    quiet, flooded = (1e3 * np.array(times[word]) for word in ("off", "on"))
    p99 = [float(np.percentile(found, 99)) for found in (quiet, flooded)]
    ratios = [
        float(np.percentile(under, 99) / np.percentile(without, 99))
        for without, under in zip(np.split(quiet, runs), np.split(flooded, runs), strict=True)
    ]
    details = (
        f"{runs} runs of {rounds * stops} stops each; p99 {p99[1]:.1f} ms against {p99[0]:.1f} ms, "
        f"median {np.median(flooded):.1f} against {np.median(quiet):.1f} ms, "
        f"worst {flooded.max():.1f} against {quiet.max():.1f} ms; answers to the sign-ins by status: {answers}"
    )
    return [
        Row(
            f"Stop with {sign_ins} sign-ins under way: p99 over that without",
            ratios,
            "x",
            REACH,
            "lower",
            details,
        )
    ]


def _in_turn(
    clock: MonotonicClock, rounds: int, stops: int, port: int, tell: Callable[[str], str]
) -> dict[str, list[float]]:
    """Return how long each stop took (s), without the flood ("off") and with it ("on")."""
    pause = random.Random(1)
    times: dict[str, list[float]] = {"off": [], "on": []}
    for word in ("off", "on") * rounds:
        tell(word)
        clock.sleep_until(clock.now() + SETTLING)
        for _ in range(stops):
            before = request(("127.0.0.1", port), "POST", "/api/v1/control/stop")
            times[word].append(monotonic() - before)
            clock.sleep_until(clock.now() + pause.uniform(*PAUSE))
    return times
