"""Measures what a reviewer who looks at trials does to Stop, to the heartbeat and to the commands of a real chair."""

from functools import partial
from itertools import pairwise
from subprocess import Popen
from typing import Final

import numpy as np

from app.clock import MonotonicClock, monotonic
from bench.children import ask, started
from bench.processes.measured_chair import MeasuredChair
from bench.row import Row
from bench.web.busy import in_turn
from bench.web.clinic import furnish_review
from bench.web.stop import served

RUNS, ROUNDS, STOPS = 3, 6, 40  # runs; rounds without and with a reviewer in each, in turn; stops in each round
DRIVES, SECONDS = 8, 4.0  # drives without and with a reviewer, in turn; s of each
KINDS: Final = {"timeline": "time lines of trials of 5 min", "picture": "replays of trials of 5 min in 3D"}
REACH_STOP, REACH_BEAT, REACH_GAP = 1.5, 200.0, 40.0  # ratio; ms, of 300 that stop the chair; ms

Figures = dict[str, list[float]]  # without ("off") and with ("on") the reviewer


def measure_review(
    runs: int = RUNS, rounds: int = ROUNDS, stops: int = STOPS, drives: int = DRIVES, seconds: float = SECONDS
) -> list[Row]:
    """Return three figures beside each kind of review: Stop, the heartbeat, and the commands at an armed chair."""
    return [row for kind in KINDS for row in _beside(kind, runs, runs * rounds, stops, drives, seconds)]


def _beside(kind: str, runs: int, rounds: int, stops: int, drives: int, seconds: float) -> list[Row]:
    clock = MonotonicClock()
    with (
        served(partial(furnish_review, kind=kind)) as (web, chair, port, arguments),
        started("bench.processes.reviewing", str(port), *arguments) as reviewer,
    ):
        try:
            times = in_turn(clock, rounds, stops, port, partial(ask, reviewer))
            beats, gaps = _drives(clock, web, reviewer, chair, drives, seconds)
            answers = ask(reviewer, "off")
        finally:
            reviewer.communicate()
    quiet, busy = (1e3 * np.array(times[word]) for word in ("off", "on"))
    ratios = [
        float(np.percentile(under, 99) / np.percentile(without, 99))
        for without, under in zip(np.split(quiet, runs), np.split(busy, runs), strict=True)
    ]
    details = (
        f"{runs} runs of {len(quiet) // runs} stops each; median {np.median(busy):.1f} against {np.median(quiet):.1f} "
        f"ms, worst {busy.max():.1f} against {quiet.max():.1f} ms; answers to the reviewer by status: {answers}"
    )
    alone = f"{drives} drives of {seconds:g} s each; without the reviewer"
    beat = f"{alone} {max(beats['off']):.0f} ms; one every 100 ms, 300 ms stop the chair"
    gap = f"{alone} {max(gaps['off']):.1f} ms; one every 20 ms"
    during = f"while a reviewer opens {KINDS[kind]}"
    return [
        Row(f"Stop {during}: p99 over that without", ratios, "x", REACH_STOP, "lower", details),
        Row(f"heartbeat of the web process {during}: longest gap", beats["on"], "ms", REACH_BEAT, "lower", beat, max),
        Row(f"commands at a real chair {during}: longest gap", gaps["on"], "ms", REACH_GAP, "lower", gap, max),
    ]


def _drives(
    clock: MonotonicClock, web: Popen[str], reviewer: Popen[str], chair: MeasuredChair, drives: int, seconds: float
) -> tuple[Figures, Figures]:
    """Return the longest time between two heartbeats, and between two commands, in each drive (ms)."""
    beats, gaps = Figures(off=[], on=[]), Figures(off=[], on=[])
    for word in ("off", "on") * drives:
        ask(reviewer, word)
        ask(web, "arm")
        ask(web, "beats")
        begun = monotonic()
        clock.sleep_until(begun + seconds)
        end = monotonic()
        beats[word].append(1e3 * float(ask(web, "beats")))
        came = [begun, *(t for t, _ in list(chair.commands) if begun < t < end), end]
        gaps[word].append(1e3 * max(after - before for before, after in pairwise(came)))
    return beats, gaps
