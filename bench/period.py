"""Measures the period of the commands at a chair, beside a busy web process and with junk on both ports."""

import json
import socket
import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np

from app.hardware.chair.key import new_key, write_key
from app.session.equipment.pairing import pair_shirt, shirt_key_file
from bench.children import ask, free_ports, next_line, started
from bench.processes.junk import KEY_ID
from bench.row import Row

SECONDS = 15.0
RUNS = 3
JUNK_RATE = 50_000.0  # datagrams/s to each of the two ports
SETTLING = 1.0  # s of junk before the measurement
WHAT = "command period at the chair, 50 Hz, under load and junk"


class PeriodRun(NamedTuple):
    """The figures of one run."""

    gaps: list[float]  # s between commands, in order
    driving: float  # share of commands that drive
    rates: list[float]  # junk sent, datagrams/s: to the chair's port, to the sender's port


def measure_period(seconds: float = SECONDS, rate: float = JUNK_RATE, runs: int = RUNS) -> list[Row]:
    """Return the p99 of the time between two commands, and the longest."""
    found = [_run(seconds, rate) for _ in range(runs)]
    p99 = [1e3 * float(np.percentile(run.gaps, 99)) for run in found]
    longest = [1e3 * max(run.gaps) for run in found]
    chairs, senders = (min(run.rates[port] for run in found) for port in (0, 1))
    commands, driving = sum(len(run.gaps) for run in found), min(run.driving for run in found)
    details = (
        f"{commands} commands in {runs} runs, {driving:.0%} of them driving, shirt at 1 kHz, beside two browsers' "
        f"worth of work; junk sent: {chairs:,.0f}/s to the chair's port, {senders:,.0f}/s to the sender's"
    )
    return [
        Row(f"{WHAT}: p99", p99, "ms", 25.0, "lower", details),
        Row(f"{WHAT}: longest gap", longest, "ms", 40.0, "lower", "the longest of all runs", max),
    ]


def _run(seconds: float, rate: float) -> PeriodRun:
    shirt_port, report_port = free_ports(2)
    key = new_key(KEY_ID)
    with (
        tempfile.TemporaryDirectory() as folder,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as chair_socket,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as elsewhere,
    ):
        chair_socket.bind(("127.0.0.1", 0))
        chair_port = chair_socket.getsockname()[1]
        key_file = Path(folder) / "1.key"
        write_key(key_file, key)
        shirt_key = str(shirt_key_file(Path(folder), pair_shirt(Path(folder)).id))
        descriptor = chair_socket.fileno()
        recording = str(Path(folder) / "run")
        with (
            started("bench.processes.chair_process", str(descriptor), str(key_file), descriptors=[descriptor]) as chair,
            started(
                "bench.processes.load",
                str(shirt_port),
                str(report_port),
                recording,
                str(chair_port),
                str(key_file),
                shirt_key,
            ) as load,
            started("bench.processes.feed", str(shirt_port), shirt_key) as feed,
        ):
            try:
                next_line(load)
                sender_port = next_line(chair)
                # Junk to the sender comes from the chair's address; the kernel would drop it from any other.
                targets = [f"{chair_port}:W:{elsewhere.fileno()}", f"{sender_port}:T:{descriptor}"]
                sources = [elsewhere.fileno(), descriptor]
                with started("bench.processes.junk", str(rate), str(seconds), *targets, descriptors=sources) as junk:
                    flood = json.loads(next_line(junk))
                noted = json.loads(ask(chair, "tell"))
            finally:
                for part in (feed, load, chair):
                    part.communicate()
    begin, end = flood["begin"] + SETTLING, flood["end"]
    times = [t for t in noted["times"] if begin < t < end]
    driving = sum(begin < t < end for t in noted["driving"])
    lasted = flood["end"] - flood["begin"]
    # Silence at the beginning and at the end counts as a gap too.
    gaps = np.diff([begin, *times, end]).tolist()
    return PeriodRun(gaps, driving / max(1, len(times)), [sent / lasted for sent in flood["sent"]])
