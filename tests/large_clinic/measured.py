"""Measures a clinic of some years: its start, its pages at the server, its web process's memory, and its backups."""

import signal
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

import httpx
import psutil
from large_clinic.furnished import Size
from processes.served_demo import bodydrive, printed_link

from app.api.sign_in.identity import COOKIE

PAGES = {  # what a page asks for; of another patient each time
    "patients' list": ("/patients",),
    "who needs attention": ("/attention",),
    "review of a patient": (
        "/trials?patient={patient}",
        "/patients/{patient}/learning?{task}&measure=e_diff",
        "/patients/{patient}/trajectories?{task}",
    ),
    "quality of control": ("/patients/{patient}/quality?{task}",),
    "a trial": ("/trials/{trial}", "/trials/{trial}/verdicts"),
    "replay of a trial": ("/trials/{trial}/timeline",),
    "log": ("/log",),
    "record of a session": ("/sessions/{session}",),
    "story of a session": ("/sessions/{session}/story",),
    "two sessions side by side": ("/sessions/{session}/comparison?other={earlier}",),
}
REPORTS = {  # files that are made while somebody waits; the limits are s, 95th percentile
    "/patients/{patient}/report?form=html&session={number}": 1.0,
    "/patients/{patient}/report?form=pdf&session={number}": 1.0,
    "/patients/{patient}/report?form=pdf": 3.0,
}
REPORT_EVERY = 4  # rounds
BACKUP_WAIT = 1200  # s
TASK = "floorplan={floorplan}&path={path}&source=worn"


class Figures(NamedTuple):
    """What was measured."""

    start: float  # s, from the command to its link
    requests: dict[str, list[float]]  # s, of each request; by its address
    memory: tuple[float, float]  # MB of the web process: after the first round, and after the last


def measure(state: Path, token: str, size: Size, rounds: int) -> Figures:
    """Serve the clinic and ask for every page `rounds` times, each time of another patient."""
    with _served(state) as (base, process, start), httpx.Client(base_url=f"{base}api/v1", timeout=60) as client:
        client.cookies.set(COOKIE, token)
        requests: dict[str, list[float]] = {}
        memory = []
        for number in range(rounds):
            patient = 1 + number * 7 % size.patients
            for page in PAGES.values():
                for address in page:
                    _ask(client, address, _names(client, patient), requests)
            for address in REPORTS if number % REPORT_EVERY == 0 else ():
                _ask(client, address, _names(client, patient), requests)
            memory.append(process.memory_info().rss / 1e6)
    return Figures(start, requests, (memory[0], memory[-1]))


def _names(client: httpx.Client, patient: int) -> dict[str, str]:
    trial = client.get(f"/trials?patient={patient}").raise_for_status().json()[-1]
    later, earlier, *_ = client.get(f"/patients/{patient}/sessions").raise_for_status().json()
    sessions = {"session": str(later["id"]), "earlier": str(earlier["id"]), "number": str(later["number"])}
    return {"patient": str(patient), "trial": str(trial["id"]), "task": TASK.format(**trial), **sessions}


def _ask(client: httpx.Client, address: str, names: dict[str, str], requests: dict[str, list[float]]) -> None:
    begin = time.perf_counter()
    client.get(address.format(**names)).raise_for_status()
    requests.setdefault(address, []).append(time.perf_counter() - begin)


def time_backups(state: Path, place: Path) -> tuple[float, float]:
    """Return how long the first backup into a folder takes, and the next one, which writes only what is new; s."""
    place.mkdir()
    times = []
    for _ in range(2):
        begin = time.perf_counter()
        with bodydrive("backup", str(place), "--state", str(state)) as process:
            _, words = process.communicate(timeout=BACKUP_WAIT)
        if process.returncode:
            raise RuntimeError(words)
        times.append(time.perf_counter() - begin)
    return times[0], times[1]


@contextmanager
def _served(state: Path) -> Iterator[tuple[str, psutil.Process, float]]:
    begin = time.perf_counter()
    with bodydrive("serve", "--port", "0", "--state", str(state)) as process:
        try:
            link = printed_link(process).partition("#")[0]
            yield link, psutil.Process(process.pid), time.perf_counter() - begin
        finally:
            process.send_signal(signal.SIGINT)
            process.wait(60)
