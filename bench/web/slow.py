"""Measures Stop on the tablet beside pages that hardly read what they are sent, and without them, on one machine."""

import os

import numpy as np

from app.clock import MonotonicClock
from bench.children import ask, started
from bench.row import Row
from bench.web.busy import in_turn
from bench.web.clinic import furnish_clinic
from bench.web.stop import served

READING, SLOW = 20, 200  # pages that read all the time; pages of the same person that hardly read
ROUNDS, STOPS = 3, 500  # rounds without and with the slow pages, in turn; stops in each, so that some are cut off
REACH, REACH_RATIO = 50.0, 2.3  # ms; in the first measurement 50 ms were 2.3 times the p99 without slow pages
REACH_TURN = 10.0  # ms


def measure_slow_pages(rounds: int = ROUNDS, stops: int = STOPS, reading: int = READING, slow: int = SLOW) -> list[Row]:
    """Return the p99 of `POST /control/stop` beside slow pages, and what they cost the event loop."""
    turns: dict[str, list[list[float]]] = {"before": [], "off": [], "on": []}
    with (
        served(furnish_clinic) as (web, _, port, (token, _)),
        started("bench.processes.slow_pages", str(port), token, str(reading), str(slow)) as pages,
    ):
        now = "before"

        def notify(word: str) -> str:
            nonlocal now
            turns[now].append([float(figure) for figure in ask(web, "turns").split()])
            now = word
            return ask(pages, word)

        try:
            times = in_turn(MonotonicClock(), rounds, stops, port, notify)
            counts = notify("off")
        finally:
            pages.communicate()
    quiet, busy = (1e3 * np.array(times[word]).reshape(rounds, stops) for word in ("off", "on"))
    p99 = {"off": np.percentile(quiet, 99, axis=1), "on": np.percentile(busy, 99, axis=1)}
    cost = {word: np.array(turns[word]) for word in ("off", "on")}
    what = f"Stop beside {slow} pages that hardly read and {reading} that do"
    details = (
        f"{rounds} rounds of {stops} stops; p99 without the slow pages {np.median(p99['off']):.1f} ms; median "
        f"{np.median(busy):.1f} against {np.median(quiet):.1f} ms, worst {busy.max():.1f} against {quiet.max():.1f} "
        f"ms; load {os.getloadavg()[1]:.1f}; {counts}"
    )
    turn = f"processor time; without the slow pages {1e3 * cost['off'][:, 1].max():.1f} ms"
    share = f"without the slow pages {100 * np.median(cost['off'][:, 2]):.0f} %"
    return [
        Row(f"{what}: p99 over that without", list(p99["on"] / p99["off"]), "x", REACH_RATIO, "lower", details),
        Row(f"{what}: p99", list(p99["on"]), "ms", REACH, "lower", "the same stops"),
        Row(
            "the longest turn of the event loop beside them",
            *(list(1e3 * cost["on"][:, 1]), "ms", REACH_TURN, "lower", turn, max),
        ),
        Row("the web process beside them", list(100 * cost["on"][:, 2]), "% of one core", None, "lower", share),
    ]
